//! A program that runs beside this one and answers questions, so that many can be measured in turn.

use std::io::{BufRead, BufReader, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use lagrangian_bench::{Integrated, Integration, Question};
use serde::de::DeserializeOwned;

/// A program that waits for a question. It ends with this value.
pub(crate) struct Contestant {
    process: Child,
    questions: Option<ChildStdin>,
    answers: BufReader<ChildStdout>,
}

impl Contestant {
    pub(crate) fn start(command: &mut Command) -> Result<Self, String> {
        let program = command.get_program().to_string_lossy().into_owned();
        let mut process = command
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(|error| format!("`{program}` cannot be run: {error}"))?;
        let questions = process.stdin.take();
        let answers = process.stdout.take().ok_or("no pipe")?;
        Ok(Self {
            process,
            questions,
            answers: BufReader::new(answers),
        })
    }

    pub(crate) fn integrate(&mut self, integration: &Integration) -> Result<Integrated, String> {
        self.ask(&Question::Integrate(integration.clone()))
    }

    /// Sends a question and waits for the answer.
    pub(crate) fn ask<T: DeserializeOwned>(&mut self, question: &Question) -> Result<T, String> {
        self.send(question)?;
        self.receive()
    }

    /// Sends a question; [`receive`](Self::receive) waits for the answer. Several contestants work at the same time if
    /// all are sent their questions first.
    pub(crate) fn send(&mut self, question: &Question) -> Result<(), String> {
        let line = serde_json::to_string(question).map_err(|error| error.to_string())?;
        let questions = self.questions.as_mut().ok_or("no pipe")?;
        writeln!(questions, "{line}")
            .and_then(|()| questions.flush())
            .map_err(|error| format!("a contestant has ended: {error}"))
    }

    /// Waits for the answer to the question that was sent.
    pub(crate) fn receive<T: DeserializeOwned>(&mut self) -> Result<T, String> {
        let mut answer = String::new();
        self.answers
            .read_line(&mut answer)
            .map_err(|error| error.to_string())?;
        if answer.is_empty() {
            return Err("a contestant has ended".to_owned());
        }
        let answer: Result<T, String> =
            serde_json::from_str(&answer).map_err(|error| format!("{answer}: {error}"))?;
        answer
    }
}

impl Drop for Contestant {
    fn drop(&mut self) {
        // No more questions: it ends.
        self.questions = None;
        drop(self.process.wait());
    }
}

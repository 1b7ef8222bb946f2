//! Editors find what each word of a declaration means.

use crate::expand::expand;

/// The tuples of what is mentioned, in order.
fn mentions(declaration: &str) -> String {
    let items = expand(declaration.parse().expect("the declaration is of tokens"));
    let items = items.to_string();
    let (_, method) = items
        .split_once("fn __mentions")
        .expect("there is a method");
    let (body, _) = method.split_once('}').expect("the method ends");
    let statements = body.split("let _ = ").skip(1);
    let statements = statements.map(|statement| statement.replace([' ', ';'], ""));
    statements.collect()
}

#[test]
fn every_word_is_mentioned_where_it_is_spoken_of() {
    let written = mentions(
        "#[lagrangian(
            coordinates(theta[3], x),
            define(h[i] = l * cos(theta[i]) for i in 0..3, Capital = x, r#loop = x),
            kinetic = 0.5 * m * dot(x).powi(2) + (0..h.len()).map(|i| dot(h[i]).powi(2)).sum(),
            potential = v.x * x.min(m) + Capital + r#loop + PI * t,
            force(theta[0] = -m, x = sin(x)),
            output(height = h[1]),
        )]
        struct Model { m: f64, l: f64, v: [f64; 3] }",
    );
    // Functions, components behind points, and variables of closures are no mentions.
    let energies = "(&self.m,Self::X,h,h,)(&self.v,Self::X,&self.m,)";
    let definitions = "(&self.l,Self::THETA,)(Self::X,)(Self::X,)";
    let outputs = "(h,)";
    let forces = "(&self.m,)(Self::X,)(Self::THETA,)(Self::X,)";
    assert_eq!(written, [energies, definitions, outputs, forces].concat());
}

#[test]
fn functions_and_their_arguments_are_mentioned() {
    let written = mentions(
        "#[lagrangian(
            coordinates(x),
            function(drag(x, Area) = self.c * x, derivative(x) = m * slope(x) * Area, derivative(Area) = 0.0),
            function(slope(v) = 1.0, derivative(v) = 0.0),
            kinetic = 0.5 * m * dot(x).powi(2),
            force(x = -drag(x, m).slope() + drag),
        )]
        struct Model { m: f64 }",
    );
    // An argument hides the coordinate, and what is no variable is left out.
    let energies = "(&self.m,Self::X,)";
    let forces = "(drag,Self::X,&self.m,slope,)(Self::X,)";
    let derivatives = "|x:()|(x,x,&self.m,slope,x,)|v:()|(v,v,)";
    assert_eq!(written, [energies, forces, derivatives].concat());
}

#[test]
fn a_declaration_with_an_error_is_understood_by_editors_too() {
    let written = mentions(
        "#[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), potential = m * )]
        struct Model { m: f64 }",
    );
    assert_eq!(written, "(&self.m,Self::X,)");
}

//! The table of samples, as comma-separated values.

use std::io::{self, Write};

use crate::record::Record;

/// The names and units of the columns.
const HEADER: &str = "t [s],phi [rad],theta [rad],psi [rad],\
    phi_dot [rad/s],theta_dot [rad/s],psi_dot [rad/s],\
    energy [J],C_phi [kg m2/s],C_psi [kg m2/s],relative energy error";

/// Writes the table. Numbers are written with as many digits as give the same number when read.
pub(crate) fn write(mut file: impl Write, records: &[Record]) -> io::Result<()> {
    writeln!(file, "{HEADER}")?;
    for record in records {
        let state = &record.state;
        write!(file, "{}", state.t)?;
        let constants = [record.energy, record.c_phi, record.c_psi, record.errors[0]];
        for value in state.q.iter().chain(&state.v).chain(&constants) {
            // Scientific notation where it is the shorter one.
            write!(file, ",{value:?}")?;
        }
        writeln!(file)?;
    }
    file.flush()
}

#[cfg(test)]
mod tests {
    use lagrangian::State;

    use super::{HEADER, write};
    use crate::record::Record;

    #[test]
    fn every_column_reads_back() {
        let record = Record {
            state: State::new(0.1 + 0.2, [1.0, -2.5, 1e-300], [3.0, 4.0, 5.0]),
            energy: 6.0,
            c_phi: 7.0,
            c_psi: 8.0,
            errors: [-1e-16, 0.0, 0.0],
        };
        let mut file = Vec::new();
        write(&mut file, &[record]).expect("a vector takes all");
        let text = String::from_utf8(file).expect("text");
        let (header, row) = text.trim_end().split_once('\n').expect("two lines");
        assert_eq!(header, HEADER);
        let values: Vec<f64> = row
            .split(',')
            .map(|value| value.parse().expect("a number"))
            .collect();
        assert_eq!(
            values,
            [
                0.1 + 0.2,
                1.0,
                -2.5,
                1e-300,
                3.0,
                4.0,
                5.0,
                6.0,
                7.0,
                8.0,
                -1e-16
            ]
        );
        assert_eq!(values.len(), HEADER.split(',').count());
    }
}

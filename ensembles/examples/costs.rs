//! What a study costs besides its motions: a member, a row, a chunk, a byte, and a message between ranks.
//!
//!     cargo run --release -p lagrangian-ensembles --features parquet --example costs
//!     mpirun -n 2 target/release/examples/costs      (built with the feature mpi)
//!
//! Its members are a mass at rest, whose motion takes one step. Times are of one thread.

use std::error::Error;
use std::fs;
use std::time::Instant;

use lagrangian::EquationsOfMotion;
use lagrangian::prelude::*;
#[cfg(feature = "mpi")]
use lagrangian_ensembles::Folder;
use lagrangian_ensembles::Study;

#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * m * dot(x).powi(2))]
struct Mass {
    m: f64,
}

/// The number of members of most studies.
const MEMBERS: usize = 1 << 17;

fn main() -> Result<(), Box<dyn Error>> {
    #[cfg(feature = "mpi")]
    {
        use lagrangian_ensembles::mpi::{self, traits::Communicator as _};
        let (universe, _) = mpi::initialize_with_threading(mpi::Threading::Funneled)
            .ok_or("MPI could not be initialized")?;
        let world = universe.world();
        if world.size() > 1 {
            return on_ranks(&world);
        }
    }
    of_members()?;
    of_chunks()
}

fn problem(_: usize) -> Problem<f64, EquationsOfMotion<Mass, f64, 1>> {
    Problem::new(Mass { m: 1.0 }, State::new(0.0, [1.0], [0.0]))
}

/// Creates a study on one thread.
macro_rules! study {
    ($members:expr, $chunk:expr) => {
        Study::new(0..$members, problem, 1.0, Taylor::new())
            .threads(1)
            .chunk($chunk)
    };
}

/// Returns the least time of five runs in s.
fn time(mut run: impl FnMut() -> Result<(), Box<dyn Error>>) -> Result<f64, Box<dyn Error>> {
    let mut fastest = f64::INFINITY;
    for _ in 0..5 {
        let start = Instant::now();
        run()?;
        fastest = fastest.min(start.elapsed().as_secs_f64());
    }
    Ok(fastest)
}

#[allow(clippy::cast_precision_loss)] // Counts are small.
fn of_members() -> Result<(), Box<dyn Error>> {
    let alone = time(|| {
        Ensemble::new((0..MEMBERS).map(problem)).solve_each(1.0, Taylor::new(), |_, _| ());
        Ok(())
    })?;
    let one = time(|| {
        study!(MEMBERS, 1 << 10).summary(["x"], |motion| [motion.q[0]])?;
        Ok(())
    })?;
    let four = time(|| {
        study!(MEMBERS, 1 << 10).summary(["a", "b", "c", "d"], |motion| [motion.q[0]; 4])?;
        Ok(())
    })?;
    let of_member = |seconds: f64| 1e9 * seconds / MEMBERS as f64;
    println!("a member of a plain `Ensemble`: {:.0} ns", of_member(alone));
    println!(
        "in a study with the statistics of one column: {:.0} ns more",
        of_member(one - alone)
    );
    println!(
        "for each further column: {:.0} ns",
        of_member((four - one) / 3.0)
    );
    Ok(())
}

#[allow(clippy::cast_precision_loss)] // Counts are small.
fn of_chunks() -> Result<(), Box<dyn Error>> {
    let place = tempfile::tempdir()?;
    let path = |chunk: usize| place.path().join(chunk.to_string());
    let write = |chunk: usize| {
        time(|| {
            if path(chunk).exists() {
                fs::remove_dir_all(path(chunk))?;
            }
            study!(MEMBERS, chunk).write(path(chunk), ["x"], |motion| [motion.index as f64])?;
            Ok(())
        })
    };
    let size = |chunk: usize| -> Result<f64, Box<dyn Error>> {
        let files = fs::read_dir(path(chunk))?;
        let sizes = files.map(|file| Ok(file?.metadata()?.len()));
        Ok(sizes.sum::<Result<u64, std::io::Error>>()? as f64)
    };
    let [few, many] = [1 << 14, 1 << 8];
    let difference = (MEMBERS / many - MEMBERS / few) as f64;
    let seconds = (write(many)? - write(few)?) / difference;
    let bytes = (size(many)? - size(few)?) / difference;
    println!(
        "a chunk, as a file: {:.0} µs and {bytes:.0} bytes",
        1e6 * seconds
    );
    println!(
        "a member in it, with one number: {:.1} bytes",
        size(few)? / MEMBERS as f64
    );
    Ok(())
}

/// What a chunk costs that a rank asks for, without its file.
#[cfg(feature = "mpi")]
fn on_ranks(
    world: &impl lagrangian_ensembles::mpi::traits::Communicator,
) -> Result<(), Box<dyn Error>> {
    use lagrangian_ensembles::mpi::traits::CommunicatorCollectives as _;
    // All ranks see one folder. An earlier run that was interrupted may have left it.
    let path = std::env::temp_dir().join("lagrangian_ensembles_costs");
    if world.rank() == 0 && path.exists() {
        fs::remove_dir_all(&path)?;
    }
    world.barrier();
    let seconds = |chunk: usize| -> Result<f64, Box<dyn Error>> {
        let start = Instant::now();
        let folder = Folder::new(path.join(chunk.to_string())).ranks(world);
        study!(1 << 12, chunk).write(folder, ["x"], |motion| [motion.q[0]])?;
        Ok(start.elapsed().as_secs_f64())
    };
    let measured = seconds(1 << 12).and_then(|one| Ok([one, seconds(1)?]));
    // An error is one of all ranks. None reads the folder any more.
    world.barrier();
    if world.rank() == 0 {
        fs::remove_dir_all(&path)?;
    }
    let [one, many] = measured?;
    if world.rank() == 0 {
        let chunk = 1e6 * (many - one) / f64::from((1 << 12) - 1);
        println!(
            "a chunk that is asked for and written, on {} ranks: {chunk:.0} µs",
            world.size()
        );
    }
    Ok(())
}

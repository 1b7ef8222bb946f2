//! Ready models for Python, to compare them with Rust.

use lagrangian_models::{
    Acrobot, Bicycle, CartPole, CartWithTwoPoles, DoublePendulum, FreeBody, FurutaPendulum,
    GeneralTop, Gyrocompass, Gyroscope, SymmetricTop,
};

lagrangian_python::module! {
    /// Ready models.
    ready: Acrobot, Bicycle, CartPole, CartWithTwoPoles, DoublePendulum, FreeBody, FurutaPendulum,
        GeneralTop, Gyrocompass, Gyroscope, SymmetricTop
}

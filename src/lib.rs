pub mod compare;
pub mod geometry;
pub mod material;
pub mod model;
pub mod record;
pub mod solver;

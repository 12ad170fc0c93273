pub mod case;
pub mod compare;
pub mod geometry;
pub mod material;
pub mod model;
pub mod quantity;
pub mod record;
pub mod solver;

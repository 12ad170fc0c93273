//! Sections of tools: distances, corners, offsets, and where they meet.

mod cavity;
mod crossing;
mod cut;
mod extreme;
mod fillet;
mod moves;
mod offset;
mod rounding;
mod shapes;

//! What the algorithms are put to: stiff and extreme cases, each with the answer that it must give.

pub mod stress;

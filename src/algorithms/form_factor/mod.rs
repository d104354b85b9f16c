//! Form factors.

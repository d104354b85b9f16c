//! The oracles: what error a link may have.

/// Says what error a link may have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Oracle {
    /// The larger of F_pq and F_qp: how large the one is, seen from the other.
    FormFactor(f64),
    /// ρ B F A: how much light the link carries.
    Carried(f64),
}

impl Oracle {
    pub fn allowed(self) -> f64 {
        let (Oracle::FormFactor(allowed) | Oracle::Carried(allowed)) = self;
        allowed
    }
}

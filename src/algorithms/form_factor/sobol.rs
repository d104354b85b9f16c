//! Sobol points in four dimensions (Sobol' 1967; direction numbers of Joe & Kuo 2008), shifted digit by digit.

use crate::numeric::Random;

/// The numbers m_k of the primitive polynomials 1 + x, 1 + x + x², 1 + x + x³ with which the recurrences start.
const POLYNOMIALS: [(u32, u32, [u32; 3]); 3] =
    [(1, 0, [1, 0, 0]), (2, 1, [1, 3, 0]), (3, 1, [1, 3, 1])];

/// A seeded sequence of points in (0, 1)⁴, each dimension stratified.
#[derive(Clone, Debug)]
pub struct Sobol {
    directions: &'static [[u32; 32]; 4],
    shift: [u32; 4],
}

static DIRECTIONS: [[u32; 32]; 4] = directions();

const fn directions() -> [[u32; 32]; 4] {
    let mut directions = [[0; 32]; 4];
    let mut k = 0;
    while k < 32 {
        directions[0][k] = 1 << (31 - k);
        k += 1;
    }
    let mut dimension = 1;
    while dimension < 4 {
        let (degree, coefficients, first) = POLYNOMIALS[dimension - 1];
        let s = degree as usize;
        let mut k = 0;
        while k < 32 {
            directions[dimension][k] = if k < s {
                first[k] << (31 - k)
            } else {
                let mut v = directions[dimension][k - s] ^ (directions[dimension][k - s] >> s);
                let mut l = 1;
                while l < s {
                    if (coefficients >> (s - 1 - l)) & 1 == 1 {
                        v ^= directions[dimension][k - l];
                    }
                    l += 1;
                }
                v
            };
            k += 1;
        }
        dimension += 1;
    }
    directions
}

impl Sobol {
    pub fn new(seed: u64) -> Self {
        let mut random = Random(seed);
        let mut next = || random.bits() as u32;
        Sobol {
            directions: &DIRECTIONS,
            shift: [next(), next(), next(), next()],
        }
    }

    pub fn point(&self, index: u32) -> [f64; 4] {
        std::array::from_fn(|dimension| {
            let mut bits = self.shift[dimension];
            let mut index = index;
            while index != 0 {
                bits ^= self.directions[dimension][index.trailing_zeros() as usize];
                index &= index - 1;
            }
            // The middle of the cell, so that no point lies on an edge.
            (f64::from(bits) + 0.5) / (1_u64 << 32) as f64
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_dimension_is_stratified_and_the_first_two_together() {
        let sobol = Sobol::new(7);
        for dimension in 0..4 {
            let mut cells = [0; 64];
            (0..64).for_each(|index| cells[(64.0 * sobol.point(index)[dimension]) as usize] += 1);
            assert_eq!(cells, [1; 64]);
        }
        let mut cells = [0; 16];
        for index in 0..16 {
            let point = sobol.point(index);
            cells[(4.0 * point[0]) as usize * 4 + (4.0 * point[1]) as usize] += 1;
        }
        assert_eq!(cells, [1; 16]);
    }
}

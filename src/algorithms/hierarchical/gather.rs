//! GatherRad: every element gathers over its own links, whatever their level.

use super::event::Event;
use super::hierarchy::Hierarchy;
use crate::color::Rgb;
use crate::record::Recorder;

impl Hierarchy<'_> {
    /// GatherRad(p): B_g = ρ_p Σ F_pq B_q over the links of p; and so for its children.
    pub fn gather<R: Recorder<Event>>(&mut self, p: u32, recorder: &mut R) {
        let links = self.links_of.links(p);
        if links.is_empty() {
            self.b_g[p as usize] = Rgb::BLACK;
        } else {
            let element = self.element(p);
            recorder.enter(|| Event::LinksGathering {
                p,
                links: links.len() as u32,
                rho_p: element.rho,
            });
            let mut sum = Rgb::BLACK;
            for link in links.iter().filter_map(|&link| self.links[link as usize]) {
                let q = if link.p == p { link.q } else { link.p };
                let f_pq = link.estimate.passing() / element.area;
                let b_q = self.b[q as usize];
                sum += b_q * f_pq;
                recorder.step(|| Event::LinkGathered { q, f_pq, b_q, sum });
            }
            let b_g = element.rho * sum;
            recorder.leave(|| Event::LinksGathered { b_g });
            self.b_g[p as usize] = b_g;
        }
        for child in self.element(p).children() {
            self.gather(child, recorder);
        }
    }
}

use super::*;
use crate::panels::PanelInput;

#[test]
fn a_picture_that_uses_the_one_before_is_as_if_drawn_anew() {
    for id in ["gouraud-triangle", "reflection", "texture-transparency"] {
        let mut session = session(id);
        go(&mut session, Command::Questions);
        let last = session.last_step();
        let mut differing = [0, 0];
        let mut before = [Panel::Image, Panel::Space].map(|_| Vec::new());
        for seventh in [0, 1, 2, 5, 4, 3, 6, 7] {
            // On, a few steps on, and a step back.
            for step in [
                last * seventh / 7,
                last * seventh / 7 + 3,
                last * seventh / 7 + 2,
            ] {
                go(&mut session, Command::Seek(step.min(last)));
                let input = session.panel_input();
                let anew = PanelInput {
                    reused: None,
                    ..input
                };
                for (number, panel) in [Panel::Image, Panel::Space].into_iter().enumerate() {
                    let [one, other] = [&input, &anew]
                        .map(|input| draw(panel, input, glam::Vec2::new(300.0, 240.0)));
                    assert_eq!(one, other, "{id}, {}, step {step}", panel.name());
                    differing[number] += usize::from(one.items != before[number]);
                    before[number] = one.items;
                }
            }
        }
        assert!(
            differing.iter().all(|&count| count > 5),
            "{id}: {differing:?}"
        );
    }
}

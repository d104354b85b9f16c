use super::*;

/// Windows in points: those of the usual screens, and what the projector's larger text leaves of them.
const WINDOWS: [Vec2; 6] = [
    vec2(1280.0, 800.0),
    vec2(1366.0, 768.0),
    vec2(1920.0, 1080.0),
    vec2(1024.0, 640.0),
    vec2(1092.8, 614.4),
    vec2(1536.0, 864.0),
];

fn wishes(others: usize) -> Wishes {
    Wishes {
        column: None,
        time_line: None,
        time_line_heights: [76.0, 120.0],
        others,
        drawer: None,
    }
}

#[test]
fn the_key_panel_has_at_least_45_percent_of_the_window() {
    for window in WINDOWS {
        for others in 0..5 {
            let key = layout(window, wishes(others)).key;
            let share = key.area() / window.x / window.y;
            assert!(share >= 0.45, "{share} of {window} with {others} others");
        }
    }
}

#[test]
fn no_card_covers_another_or_leaves_the_window() {
    for window in WINDOWS
        .into_iter()
        .chain([vec2(900.0, 600.0), vec2(720.0, 480.0)])
    {
        for (others, drawer) in [
            (0, None),
            (3, None),
            (5, None),
            (3, Some(DRAWER)),
            (3, Some(WRITING)),
        ] {
            let layout = layout(
                window,
                Wishes {
                    drawer,
                    ..wishes(others)
                },
            );
            let cards = [layout.column, layout.key, layout.time_line].into_iter();
            let cards: Vec<Rect> = cards.chain(layout.side).chain(layout.drawer).collect();
            let whole = Rect::from_min_size(egui::Pos2::ZERO, window);
            for (i, card) in cards.iter().enumerate() {
                assert!(
                    whole.contains_rect(*card) && card.is_positive(),
                    "{card} in {window}"
                );
                let covers = |other: &Rect| card.intersect(*other).is_positive();
                assert!(!cards[..i].iter().any(covers), "{card} in {window}");
            }
        }
    }
}

#[test]
fn a_low_column_scrolls_and_its_regions_have_what_they_need() {
    assert_eq!(column_height(450.0, 300.0, 120.0), 450.0);
    for (said, formula) in [(60.0, 70.0), (300.0, 170.0)] {
        let height = column_height(240.0, said, formula);
        let card = Rect::from_min_size(pos2(8.0, 48.0), vec2(230.0, height));
        let column = column(card, said, formula);
        assert!(column.said.height() >= said - 1e-3 && column.formula.height() >= formula - 1e-3);
        assert!(column.code.height() >= LEAST_CODE - 1e-3);
    }
}

#[test]
fn the_regions_of_the_column_share_its_height_and_none_is_pushed_out() {
    let card = Rect::from_min_size(pos2(8.0, 48.0), vec2(300.0, 450.0));
    for said in [0.0, 100.0, 300.0, 2000.0] {
        for formula in [0.0, 120.0, 400.0] {
            let column = column(card, said, formula);
            let heights = [column.said, column.code, column.formula].map(|part| part.height());
            assert!((heights.iter().sum::<f32>() - card.height()).abs() < 1e-3);
            let least = [
                LEAST_SAID * card.height(),
                100.0,
                formula.clamp(64.0, 225.0),
            ];
            let enough = heights
                .iter()
                .zip(least)
                .all(|(&height, least)| height >= least);
            assert!(enough, "{heights:?}, {least:?}");
        }
    }
}

//! The search for the nearest object, and for what stands before a light.

use super::entry::{When, entry, is, only};
use super::intersection::{
    BEHIND_LIGHT, BLOCKS, MET_BEHIND, MET_NEARER, MISSED, MISSED_ON_THE_WAY,
};
use crate::algorithms::visible::{Event, Intersection};

vocabulary! {
    [] Event {
    };
    Event::Search { objects } => "Search" at "search" scope "scope-search"
        {
            "objects" = objects,
            "NearestT" = f64::INFINITY,
        }
        [
            entry("event-search", &[is("NearestT")]),
        ];
    Event::ObjectTested { object, t, nearest_t, nearer, .. } => "ObjectTested" at "test" or "nearer" if nearer,
        {
            "object" = object,
            "t" = t,
            "NearestT" = nearest_t,
            "nearer" = nearer,
        }
        [
            only(When::True("nearer"), "event-object-tested-nearer", MET_NEARER),
            only(When::Finite("t"), "event-object-tested-behind", MET_BEHIND),
            entry("event-object-tested-missed", MISSED),
        ];
    Event::LightTested { light, t, nearest_t, nearer } => "LightTested" at "test" or "nearer" if nearer,
        {
            "light" = light,
            "t" = t,
            "NearestT" = nearest_t,
            "nearer" = nearer,
        }
        [
            only(When::True("nearer"), "event-light-tested-nearer", MET_NEARER),
            only(When::Finite("t"), "event-light-tested-behind", MET_BEHIND),
            entry("event-light-tested-missed", MISSED),
        ];
    Event::Found { met } => "Found" at "found"
        {
            "met" = met_name(&met),
            "light" = met_light(&met),
            "object" = met_object(&met),
            "NearestT" = met.t(),
        }
        [
            only(When::Is("met", "object"), "event-found-object", &[is("NearestT")]),
            only(When::Is("met", "light"), "event-found-light", &[is("NearestT")]),
            entry("event-found-nothing", &[is("NearestT")]),
        ];
    Event::BetweenTested { object, t, distance, blocks, .. } => "BetweenTested" at "shadow"
        {
            "object" = object,
            "t" = t,
            "d" = distance,
            "blocks" = blocks,
        }
        [
            only(When::True("blocks"), "event-between-tested-blocks", BLOCKS),
            only(When::Finite("t"), "event-between-tested-behind", BEHIND_LIGHT),
            entry("event-between-tested-missed", MISSED_ON_THE_WAY),
        ];
    Event::Unshadowing { object } => "Unshadowing" at "shadow"
        {
            "object" = object,
            "blocks" = false,
        }
        [
            entry("event-unshadowing", &[]),
        ];
}

fn met_name(met: &Intersection) -> &'static str {
    match met {
        Intersection::Nothing => "nothing",
        Intersection::Light { .. } => "light",
        Intersection::Object(_) => "object",
    }
}

fn met_light(met: &Intersection) -> Option<u32> {
    match *met {
        Intersection::Light { light, .. } => Some(light),
        _ => None,
    }
}

fn met_object(met: &Intersection) -> Option<u32> {
    match met {
        Intersection::Object(hit) => Some(hit.object),
        _ => None,
    }
}

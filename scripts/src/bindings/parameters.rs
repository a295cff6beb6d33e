//! The values that were chosen, as the one argument of `run`: `parameters.length_s`.

use super::Answer;
use crate::error::{Said, did_you_mean};
use crate::parameter::{ParameterValue, Values};
use rhai::{Dynamic, Engine, ImmutableString};
use std::rc::Rc;

/// Shared, so that handing it on costs nothing.
#[derive(Debug, Clone)]
pub(crate) struct Parameters(Rc<Values>);

impl Parameters {
    pub(crate) fn new(values: &Values) -> Self {
        Self(Rc::new(values.clone()))
    }

    fn get(&self, name: &str) -> Answer<Dynamic> {
        let values = &self.0.0;
        Ok(match values.get(name) {
            Some(ParameterValue::Flag(flag)) => Dynamic::from_bool(*flag),
            Some(ParameterValue::Number(number)) => Dynamic::from_float(*number),
            Some(ParameterValue::Whole(whole)) => Dynamic::from_int(*whole),
            Some(ParameterValue::Text(text)) => text.into(),
            Some(ParameterValue::Color(channels)) => super::convert::of_vector(*channels),
            Some(ParameterValue::Curve(points)) => {
                let point = |point: &[f64; 2]| Dynamic::from_array(point.map(Dynamic::from_float).to_vec());
                Dynamic::from_array(points.iter().map(point).collect())
            }
            None => {
                let hint = did_you_mean(name, values.keys().map(String::as_str));
                return Err(Said::script(format!("PLUGIN has no parameter `{name}`"), hint).into());
            }
        })
    }
}

pub(super) fn register(engine: &mut Engine) {
    engine.register_type_with_name::<Parameters>("Parameters");
    engine.register_indexer_get(|parameters: &mut Parameters, name: ImmutableString| parameters.get(&name));
}

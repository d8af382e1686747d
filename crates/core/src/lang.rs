//! The two languages of every answer.

/// A language of the answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lang {
    /// Ukrainian.
    Uk,
    /// English.
    En,
}

impl Lang {
    /// The language of an environment variable `LANG`: English for `en…`, else Ukrainian.
    pub fn of_environment(variable: Option<&str>) -> Self {
        let primary = variable.unwrap_or_default().split(['_', '.', '-', '@']).next().unwrap_or_default();
        if primary.eq_ignore_ascii_case("en") { Self::En } else { Self::Uk }
    }

    /// The one of two texts in this language.
    pub const fn pick<'a>(self, uk: &'a str, en: &'a str) -> &'a str {
        match self {
            Self::Uk => uk,
            Self::En => en,
        }
    }
}

impl std::str::FromStr for Lang {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "uk" => Ok(Self::Uk),
            "en" => Ok(Self::En),
            other => Err(format!("`{other}` is neither uk nor en")),
        }
    }
}

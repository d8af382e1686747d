//! Audits of many plans: the files of a folder.

use serde::Serialize;
use technolog_core::lang::Lang;

use crate::knowledge::Diagnostic;

use super::finding::{Audit, Counts};

/// The result for one file.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub enum Audited {
    /// A plan, audited.
    Plan(Box<Audit>),
    /// A plan that cannot be read.
    Unreadable(Unread),
}

/// A plan that cannot be read, and why.
#[derive(Clone, Debug, Serialize)]
pub struct Unread {
    /// Its file.
    pub file: String,
    /// Every mistake of it.
    pub unreadable: Vec<Mistake>,
}

/// A mistake of a file.
#[derive(Clone, Debug, Serialize)]
pub struct Mistake {
    /// Stable id of its kind.
    pub code: &'static str,
    /// What is wrong.
    pub message: String,
    /// `file:line:column`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub place: Option<String>,
    /// What to do.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub help: Option<String>,
}

impl Unread {
    /// A file with its problems.
    pub fn new(file: &str, problems: &[Diagnostic], lang: Lang) -> Self {
        let mistake = |problem: &Diagnostic| Mistake {
            code: problem.code,
            message: lang.say(&problem.message),
            place: problem.place.as_ref().map(ToString::to_string),
            help: problem.help.as_ref().map(|help| lang.say(help)),
        };
        Self { file: file.to_owned(), unreadable: problems.iter().map(mistake).collect() }
    }
}

impl Audited {
    /// The audit, where there is one.
    pub fn audit(&self) -> Option<&Audit> {
        match self {
            Self::Plan(audit) => Some(audit),
            Self::Unreadable(_) => None,
        }
    }
}

/// The findings of all plans by severity.
pub fn total(audited: &[Audited]) -> Counts {
    audited.iter().filter_map(Audited::audit).fold(Counts::default(), |all, audit| {
        let own = audit.summary.all;
        Counts {
            error: all.error + own.error,
            wrong: all.wrong + own.wrong,
            doubtful: all.doubtful + own.doubtful,
            note: all.note + own.note,
            follow: all.follow + own.follow,
        }
    })
}

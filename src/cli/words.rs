//! The texts of the command line, each as a function of its figures; the words are in the message catalogue.

use std::fmt::Display;

use technolog::note::Note;
pub use technolog::report::Lang;

macro_rules! phrases {
    ($($name:ident($($arg:ident),*): $key:literal;)*) => {$(
        #[doc = concat!("The message `", $key, "`.")]
        pub fn $name(lang: Lang, $($arg: impl Display),*) -> String {
            lang.say(&Note::new($key)$(.with(stringify!($arg).replace('_', "-"), $arg.to_string()))*)
        }
    )*};
}

phrases! {
    unknown_table(id): "cli-unknown-table";
    did_you_mean(name): "cli-did-you-mean";
    list_tables(): "cli-list-tables";
    no_format(command, format): "cli-no-format";
    formats(known): "cli-formats";
    format_contradiction(file, meant, asked): "cli-format-contradiction";
    format_contradiction_help(): "cli-format-contradiction-help";
    cannot_write(path, error): "cli-cannot-write";
    check_folder(): "cli-check-folder";
    cannot_print(error): "cli-cannot-print";
    print_to_file(): "cli-print-to-file";
    broken_build(error): "cli-broken-build";
    rebuild(): "cli-rebuild";
    no_hole(path, name): "cli-no-hole";
    known(names): "cli-known";
    option_of_lists(option): "cli-option-of-lists";
    leave_out(option): "cli-leave-out";
    no_control(machine): "cli-no-control";
    alien_control(machine, control): "cli-alien-control";
    name_control(known): "cli-name-control";
    run_lint(): "cli-run-lint";
}

#[cfg(test)]
mod tests {
    use super::*;
    use technolog::words::say;

    #[test]
    fn the_language_comes_from_the_first_part_of_lang() {
        for (variable, lang) in [
            (None, Lang::UK),
            (Some(""), Lang::UK),
            (Some("C"), Lang::UK),
            (Some("uk_UA.UTF-8"), Lang::UK),
            (Some("en_US.UTF-8"), Lang::EN),
            (Some("en"), Lang::EN),
            (Some("enm_XX"), Lang::UK),
        ] {
            assert_eq!(Lang::of_environment(variable), lang, "{variable:?}");
        }
    }

    #[test]
    fn ukrainian_nouns_follow_their_number() {
        for (count, text) in
            [(0, "0 рядків"), (1, "1 рядок"), (3, "3 рядки"), (12, "12 рядків"), (21, "21 рядок"), (104, "104 рядки")]
        {
            assert_eq!(say!(Lang::UK, "cli-rows-counted", count = count), text);
        }
    }
}

//! A verb's table as a subcommand with its arguments, and back as what was given.
//!
//! Next door: the tables (`coilsense_lab::report::verbs`), the verbs (`analyze` and others).

use clap::builder::{PathBufValueParser, StyledStr, TypedValueParser, ValueParser};
use clap::{Arg, ArgAction, ArgMatches, Command};
use coilsense_lab::request::{Door, Given, IfAbsent, Row, Takes, Value, Verb, Wrong};

use crate::{date, examples};

/// Name of the option by which nothing is said but what goes wrong.
pub const QUIET: &str = "quiet";

/// Said before or behind any verb.
pub fn quiet() -> Arg {
    let help = "Print nothing but errors, and JSON where it is asked for: files and the exit code tell";
    Arg::new(QUIET).short('q').long(QUIET).global(true).action(ArgAction::SetTrue).help(help)
}

/// The options of a verb that the command has.
fn rows(verb: &Verb) -> impl Iterator<Item = &'static Row> + use<> {
    verb.rows().filter(|row| row.elsewhere(Door::Command).is_none())
}

/// The subcommand of a verb.
pub fn command(verb: &'static Verb) -> Command {
    let command = Command::new(verb.name).about(verb.about).after_help(examples::of(verb.name));
    let command = match verb.more {
        "" => command,
        more => command.after_long_help(format!("{more}\n\n{}", examples::of(verb.name).ansi())),
    };
    rows(verb).fold(command, |command, row| command.arg(argument(row)))
}

fn argument(row: &'static Row) -> Arg {
    let argument = Arg::new(row.name)
        .help(StyledStr::from(row.help()))
        .conflicts_with_all(row.conflicts)
        .required(row.if_absent == IfAbsent::Refused);
    let argument = if row.by_place { argument } else { argument.long(row.flag()) };
    let argument = if row.heading.is_empty() { argument } else { argument.help_heading(row.heading) };
    let argument = row.requires.iter().fold(argument, |argument, other| argument.requires(*other));
    let argument = match row.if_absent {
        IfAbsent::Value(text) => argument.default_value(text),
        IfAbsent::RefusedWithout(other) => argument.required_unless_present(other),
        IfAbsent::Nothing | IfAbsent::Found(_) | IfAbsent::Refused => argument,
    };
    match row.takes {
        Takes::Flag => argument.action(ArgAction::SetTrue),
        _ => argument
            .value_name(row.value_name())
            .action(if row.repeated { ArgAction::Append } else { ArgAction::Set })
            .allow_hyphen_values(may_be_negative(row.takes))
            .value_parser(parser(row)),
    }
}

/// Whether its values begin with a minus.
fn may_be_negative(takes: Takes) -> bool {
    matches!(takes, Takes::Quantity(_) | Takes::Number | Takes::Count | Takes::Form(..))
}

fn parser(row: &'static Row) -> ValueParser {
    match row.takes {
        Takes::File(_) => ValueParser::new(PathBufValueParser::new().map(Value::File)),
        Takes::Date => ValueParser::new(|text: &str| date::parse(text).map(Value::Text)),
        _ => ValueParser::new(move |text: &str| row.read(text)),
    }
}

/// What was given of a verb's options.
pub fn given(verb: &Verb, matches: &ArgMatches) -> Given {
    let mut given = Given::default();
    for row in rows(verb) {
        match row.takes {
            Takes::Flag if matches.get_flag(row.name) => given.set(row, Vec::new()),
            Takes::Flag => (),
            _ => {
                let values = matches.get_many::<Value>(row.name);
                values.into_iter().for_each(|values| given.set(row, values.cloned().collect()));
            }
        }
    }
    given
}

/// An option that cannot be, as the command has it.
pub fn wrong(wrong: Wrong) -> anyhow::Error {
    anyhow::anyhow!("--{wrong}")
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use coilsense_lab::report::verbs::VERBS;

    use super::*;

    #[test]
    fn the_command_has_the_options_of_the_tables_and_no_other() {
        let mut whole = crate::command();
        whole.build();
        let others = ["help", crate::shell::COMPLETIONS, crate::shell::MAN];
        let named: Vec<&str> =
            whole.get_subcommands().map(Command::get_name).filter(|name| !others.contains(name)).collect();
        assert_eq!(named, VERBS.map(|verb| verb.name));
        assert_eq!(crate::RUNS.map(|(name, _)| name), VERBS.map(|verb| verb.name));
        for (verb, command) in VERBS.iter().zip(whole.get_subcommands()) {
            let of_all = ["help", "version", QUIET];
            let arguments = || command.get_arguments().filter(|argument| !of_all.contains(&argument.get_id().as_str()));
            let found: BTreeSet<&str> = arguments().map(|argument| argument.get_id().as_str()).collect();
            assert_eq!(found, rows(verb).map(|row| row.name).collect(), "{}", verb.name);
            for argument in arguments() {
                let row = rows(verb).find(|row| row.name == argument.get_id().as_str()).unwrap();
                assert_eq!(argument.get_long().map(str::to_owned), (!row.by_place).then(|| row.flag()));
                let default = argument.get_default_values().first().and_then(|value| value.to_str());
                let expected = if let IfAbsent::Value(text) = row.if_absent { Some(text) } else { None };
                assert!(default == expected || matches!(row.takes, Takes::Flag), "{} {}", verb.name, row.name);
            }
        }
    }

    #[test]
    fn a_row_of_the_table_is_all_that_an_option_takes() {
        use coilsense_lab::quantity::Dimension;
        use coilsense_lab::request::Allowed;
        const TOY: Row = Row {
            name: "toy_force",
            takes: Takes::Quantity(Dimension::Force),
            allowed: Allowed::AboveZero,
            if_absent: IfAbsent::Value("2 N"),
            meaning: "A toy",
            ..Row::PLAIN
        };
        const VERB: Verb = Verb { name: "toy", about: "Toys", groups: &[&[TOY]], more: "" };
        let said = |words: &[&str]| command(&VERB).try_get_matches_from([&["toy"], words].concat());
        let number = |words: &[&str]| given(&VERB, &said(words).unwrap()).number(&TOY);
        assert_eq!((number(&[]), number(&["--toy-force", "3 kN"])), (Some(2.0), Some(3000.0)));
        assert!(said(&["--toy-force", "0 N"]).unwrap_err().to_string().contains("must be above zero"));
        let help = command(&VERB).render_long_help().to_string();
        assert!(help.contains("--toy-force <FORCE>") && help.contains("A toy") && help.contains("2 N"), "{help}");
    }

    #[test]
    fn what_is_given_comes_back_in_si_units_or_is_refused_in_a_line() {
        let said = |words: &[&str]| {
            let matches =
                crate::command().try_get_matches_from([&["coilsense", "identify", "run.csv"], words].concat())?;
            let verb = VERBS.iter().find(|verb| verb.name == "identify").unwrap();
            Ok::<_, clap::Error>(given(verb, matches.subcommand().unwrap().1))
        };
        let read =
            said(&["--from", "-20 ms", "--sort", "--mass", "65 g", "--column", "a=b", "--column", "c=d"]).unwrap();
        use coilsense_lab::recording::request::{COLUMN, FROM, MERGE_REPEATED, SORT};
        assert_eq!((read.number(&FROM), read.texts(&COLUMN).len()), (Some(-0.02), 2));
        assert!(read.holds(&SORT) && !read.holds(&MERGE_REPEATED));
        for words in [
            ["--sample-rate", "-1 Hz"],
            ["--fill-gaps", "0 s"],
            ["--from", "NaN s"],
            ["--windings", "-5"],
            ["--tolerance", "100 %"],
            ["--accuracy-force", "-1 %"],
            ["--end2", "loose"],
        ] {
            let refused = said(&words).unwrap_err();
            assert_eq!(refused.kind(), clap::error::ErrorKind::ValueValidation, "{words:?}");
            let told = refused.to_string();
            let first = told.lines().next().unwrap();
            assert!(first.contains("must be ") && !told.contains("possible values"), "{told}");
        }
    }
}

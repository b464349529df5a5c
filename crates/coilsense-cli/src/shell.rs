//! `coilsense completions` and `coilsense man`: what a shell completes, and the manual's pages, of the same tables as the help.
//!
//! Next door: the verbs (`options`), where answers go (`terminal`).

use std::path::{Path, PathBuf};

use anyhow::Context;
use clap::builder::{PathBufValueParser, PossibleValuesParser};
use clap::{Arg, ArgMatches, Command};
use clap_complete::Shell;
use coilsense_lab::output::Output;

use crate::terminal;

/// Names of both.
pub const COMPLETIONS: &str = "completions";
pub const MAN: &str = "man";
const SHELLS: [&str; 5] = ["bash", "elvish", "fish", "powershell", "zsh"];

/// Both, as subcommands.
pub fn commands() -> [Command; 2] {
    let shell = Arg::new("shell")
        .required(true)
        .value_name("SHELL")
        .help("Of which shell")
        .value_parser(PossibleValuesParser::new(SHELLS));
    let out = Arg::new("out")
        .long("out")
        .value_name("DIR")
        .required(true)
        .help("Folder for coilsense.1 and a page for each subcommand; other files are left alone")
        .value_parser(PathBufValueParser::new());
    let overwrite = Arg::new("overwrite")
        .long("overwrite")
        .action(clap::ArgAction::SetTrue)
        .help("Write over pages that are there");
    [
        Command::new(COMPLETIONS)
            .about("What a shell needs to complete this command, on standard output")
            .arg(shell)
            .after_help("Examples:\n  coilsense completions bash > ~/.local/share/bash-completion/completions/coilsense\n  coilsense completions fish > ~/.config/fish/completions/coilsense.fish\n  coilsense completions powershell | Out-String | Invoke-Expression"),
        Command::new(MAN)
            .about("The manual's pages for `man`")
            .arg(out)
            .arg(overwrite)
            .after_help("Examples:\n  coilsense man --out ~/.local/share/man/man1"),
    ]
}

/// Runs one of both.
pub fn run(name: &str, said: &ArgMatches) -> anyhow::Result<()> {
    if name == COMPLETIONS {
        let shell: Shell = said.get_one::<String>("shell").context("no shell")?.parse().map_err(anyhow::Error::msg)?;
        let mut script = Vec::new();
        clap_complete::generate(shell, &mut crate::command(), "coilsense", &mut script);
        return Ok(terminal::raw(&String::from_utf8(script)?)?);
    }
    let folder: &PathBuf = said.get_one("out").context("no folder")?;
    let files = pages(folder, said.get_flag("overwrite"))?;
    Ok(terminal::say(&format!(
        "{files} pages in {0}; read them: man -l {1}\n",
        folder.display(),
        folder.join("coilsense.1").display()
    ))?)
}

/// A page for the command and one for each verb, in a folder; how many.
fn pages(folder: &Path, overwrite: bool) -> anyhow::Result<usize> {
    let mut output = Output::begin(folder)?.overwriting(overwrite);
    let mut whole = crate::command();
    whole.build();
    let mut add = |name: String, command: Command| -> anyhow::Result<()> {
        let mut page = Vec::new();
        clap_mangen::Man::new(command).render(&mut page)?;
        output.add(&format!("{name}.1"), &page)?;
        Ok(())
    };
    for verb in whole.get_subcommands().filter(|verb| verb.get_name() != "help") {
        let name = format!("coilsense-{}", verb.get_name());
        add(name.clone(), verb.clone().name(name.clone()).display_name(name))?;
    }
    add("coilsense".to_owned(), whole)?;
    Ok(output.commit()?)
}

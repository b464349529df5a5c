//! `coilsense-bindgen WASM DIR`: writes into DIR the wasm as a browser takes it, its JavaScript and its TypeScript types.
//!
//! Next door: the crate it is made for (`coilsense-web`), who calls this (`xtask`).

use std::fs;
use std::path::Path;
use std::process::ExitCode;

use wasm_bindgen_cli_support::Bindgen;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [wasm, folder] = arguments.as_slice() else {
        eprintln!("error: wanted: coilsense-bindgen WASM DIR");
        return ExitCode::from(2);
    };
    match written(wasm, folder) {
        Ok(()) => ExitCode::SUCCESS,
        Err(reason) => {
            eprintln!("error: {wasm}: {reason}");
            ExitCode::from(2)
        }
    }
}

fn written(wasm: &str, folder: &str) -> Result<(), String> {
    let mut bindgen = Bindgen::new();
    bindgen.input_path(wasm).typescript(true).remove_name_section(true);
    bindgen.web(true).map_err(|error| format!("{error:#}"))?;
    bindgen.generate(folder).map_err(|error| format!("{error:#}"))?;
    let name = Path::new(wasm).file_stem().unwrap_or_default().to_string_lossy();
    let file = Path::new(folder).join(format!("{name}_bg.wasm"));
    let made = fs::read(&file).map_err(|error| format!("{}: {error}", file.display()))?;
    let kept = without_custom_sections(&made).ok_or("is cut off")?;
    fs::write(&file, kept).map_err(|error| format!("{}: {error}", file.display()))
}

/// Magic and version.
const HEAD: usize = 8;

/// A module without what only tools read: who made it, and which features it was told to use.
fn without_custom_sections(module: &[u8]) -> Option<Vec<u8>> {
    let mut kept = module.get(..HEAD)?.to_vec();
    let mut at = HEAD;
    while at < module.len() {
        let begin = at;
        let kind = module[at];
        let (size, after) = unsigned(module, at + 1)?;
        at = after.checked_add(size)?;
        let section = module.get(begin..at)?;
        if kind != 0 {
            kept.extend_from_slice(section);
        }
    }
    Some(kept)
}

/// A LEB128 number and what comes after it.
fn unsigned(bytes: &[u8], mut at: usize) -> Option<(usize, usize)> {
    let (mut value, mut shift) = (0_usize, 0);
    loop {
        let byte = *bytes.get(at)?;
        at += 1;
        value |= usize::from(byte & 127).checked_shl(shift)?;
        shift += 7;
        if byte < 128 {
            return Some((value, at));
        }
    }
}

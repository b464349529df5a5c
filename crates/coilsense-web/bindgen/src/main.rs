//! `coilsense-bindgen WASM DIR`: writes into DIR the wasm as a browser takes it, its JavaScript and its TypeScript types.
//!
//! Next door: the crate it is made for (`coilsense-web`), who calls this (`xtask`).

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
    bindgen.generate(folder).map_err(|error| format!("{error:#}"))
}

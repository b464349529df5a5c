//! The tables of materials, sensors and the paper without what only people read in them (comments, notes, sources), for builds that show none of
//! it: a page loads some kilobytes less.

use std::path::Path;
use std::{env, fs, io};

/// Keys of a table that say where its values are from.
const TOLD: [&str; 3] = ["note", "derived", "source"];

fn main() -> io::Result<()> {
    let out = env::var_os("OUT_DIR").unwrap_or_default();
    for name in [
        "materials.toml",
        "sensors.toml",
        "springs/S_T.toml",
        "springs/S_A.toml",
        "paper/table-2.csv",
        "paper/table-3.csv",
    ] {
        println!("cargo::rerun-if-changed=data/{name}");
        let text = fs::read_to_string(Path::new("data").join(name))?;
        let is_told = |line: &&str| {
            let key = line.split('=').next().unwrap_or_default().trim();
            line.trim_start().starts_with('#') || TOLD.contains(&key)
        };
        let kept = text.lines().filter(|line| !is_told(line) && !line.trim().is_empty());
        let kept: Vec<&str> = kept.map(|line| line.split("  #").next().unwrap_or_default().trim_end()).collect();
        let file = Path::new(name).file_name().unwrap_or_default();
        fs::write(Path::new(&out).join(file), kept.join("\n"))?;
    }
    Ok(())
}

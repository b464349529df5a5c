//! With the feature `app`: whether the page that goes into the binary has been built.
//!
//! Next door: what serves it (`src/app`).

/// Where `cargo xtask page` puts the page.
const PAGE: &str = "../../web/dist";

fn main() {
    println!("cargo::rustc-check-cfg=cfg(page_is_built)");
    println!("cargo::rerun-if-changed=build.rs");
    if std::env::var_os("CARGO_FEATURE_APP").is_none() {
        return;
    }
    println!("cargo::rerun-if-changed={PAGE}");
    if std::path::Path::new(PAGE).join("index.html").is_file() {
        println!("cargo::rustc-cfg=page_is_built");
    } else {
        // Whoever checks all features needs no page; whoever runs this binary is told once more.
        println!(
            "cargo::warning=web/dist is not there: `coilsense app` will have no page to show; build that first: cargo xtask page"
        );
    }
}

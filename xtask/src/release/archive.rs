//! Archives of the program for people who do not build it.

use super::{Outcome, materials, said, version};
use crate::test::target;
use crate::{cargo, root};
use serde_json::Value;
use sha2::{Digest, Sha256};
use std::env::consts::EXE_SUFFIX;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The shells that completions are for, and the files that they look for.
const SHELLS: [(&str, &str); 5] = [
    ("bash", "coface.bash"),
    ("zsh", "_coface"),
    ("fish", "coface.fish"),
    ("powershell", "coface.ps1"),
    ("elvish", "coface.elv"),
];

/// What stands beside the program.
const TEXTS: [&str; 6] =
    ["README.md", "CHANGELOG.md", "CITATION.cff", "LICENSE-APACHE", "LICENSE-MIT", "SECURITY.md"];

/// Builds the program unless it `is_built`, and puts it into `dist/` with all that belongs to it.
pub(super) fn archive(is_built: bool) -> Outcome<()> {
    if !is_built {
        said(&mut cargo(&["build", "--release", "--locked", "--package", "coface-cli"]))?;
    }
    let program = target().join("release").join(format!("coface{EXE_SUFFIX}"));
    if !program.is_file() {
        return Err("target/release has no program; leave --no-build out".into());
    }
    let own = version::current(&fs::read_to_string(root().join("Cargo.toml"))?)?;
    let host = host()?;
    let name = format!("coface-{own}-{host}");
    let dist = root().join("dist");
    let folder = dist.join(&name);
    if folder.exists() {
        fs::remove_dir_all(&folder)?;
    }
    fs::create_dir_all(folder.join("completions"))?;
    fs::copy(&program, folder.join(format!("coface{EXE_SUFFIX}")))?;
    for text in TEXTS {
        fs::copy(root().join(text), folder.join(text))?;
    }
    for (shell, file) in SHELLS {
        let script = said(Command::new(&program).args(["completions", shell]))?;
        fs::write(folder.join("completions").join(file), script)?;
    }
    said(Command::new(&program).args(["man", "--quiet", "-o"]).arg(folder.join("man")))?;
    let metadata =
        said(&mut cargo(&["metadata", "--format-version", "1", "--locked", "--filter-platform", &host]))?;
    let metadata: Value = serde_json::from_str(&metadata)?;
    let lock = fs::read_to_string(root().join("Cargo.lock"))?;
    let bill = serde_json::to_string_pretty(&materials::bill(&metadata, &lock, "coface-cli")?)?;
    fs::write(folder.join("coface.cdx.json"), bill + "\n")?;
    let mut made = vec![packed(&dist, &name)?];
    made.extend(debian(&dist, &folder, &own.to_string())?);
    let studio = dist.join("studio.html");
    if studio.is_file() {
        made.push(studio);
    } else {
        println!("dist/studio.html is not there: cargo xtask studio makes it");
    }
    let mut sums = String::new();
    for file in &made {
        let bytes = fs::read(file)?;
        let sum: String = Sha256::digest(&bytes).iter().map(|byte| format!("{byte:02x}")).collect();
        let name = file.file_name().unwrap_or_default().to_string_lossy();
        println!("{name}: {} bytes", bytes.len());
        sums.push_str(&format!("{sum}  {name}\n"));
    }
    fs::write(dist.join("SHA256SUMS"), sums)?;
    println!("dist/SHA256SUMS has their checksums");
    Ok(())
}

/// The kind of machine that the compiler builds for.
fn host() -> Outcome<String> {
    let text = said(Command::new("rustc").arg("-vV"))?;
    Ok(text.lines().find_map(|line| line.strip_prefix("host: ")).ok_or("rustc -vV names no host")?.to_owned())
}

/// The folder as one file.
fn packed(dist: &Path, name: &str) -> Outcome<PathBuf> {
    let file = dist.join(format!("{name}.{}", if cfg!(windows) { "zip" } else { "tar.gz" }));
    let mut tar = Command::new("tar");
    if cfg!(windows) {
        tar.arg("-a");
    } else {
        tar.arg("-z");
    }
    if cfg!(target_os = "linux") {
        // The same bytes whoever packs, whenever.
        let date = said(Command::new("git").args(["log", "-1", "--format=@%ct"]))?;
        tar.args(["--sort=name", "--owner=0", "--group=0", "--numeric-owner", "--mtime", date.trim()]);
    }
    said(tar.arg("-cf").arg(&file).arg("-C").arg(dist).arg(name))?;
    Ok(file)
}

/// A package of Debian, where its tool is.
fn debian(dist: &Path, folder: &Path, version: &str) -> Outcome<Option<PathBuf>> {
    let architecture = Command::new("dpkg").arg("--print-architecture").output();
    let Some(architecture) = architecture.ok().filter(|output| output.status.success()) else {
        println!("no .deb: dpkg-deb is not installed");
        return Ok(None);
    };
    let architecture = String::from_utf8(architecture.stdout)?.trim().to_owned();
    let tree = target().join("debian");
    if tree.exists() {
        fs::remove_dir_all(&tree)?;
    }
    let place = |from: &Path, to: &str| -> Outcome<()> {
        let to = tree.join(to);
        fs::create_dir_all(to.parent().unwrap_or(&tree))?;
        fs::copy(from, &to).map_err(|error| format!("{}: {error}", from.display()))?;
        Ok(())
    };
    place(&folder.join("coface"), "usr/bin/coface")?;
    place(&folder.join("completions/coface.bash"), "usr/share/bash-completion/completions/coface")?;
    place(&folder.join("completions/_coface"), "usr/share/zsh/vendor-completions/_coface")?;
    place(&folder.join("completions/coface.fish"), "usr/share/fish/vendor_completions.d/coface.fish")?;
    place(&folder.join("LICENSE-MIT"), "usr/share/doc/coface/copyright")?;
    place(&folder.join("CHANGELOG.md"), "usr/share/doc/coface/changelog")?;
    for page in fs::read_dir(folder.join("man"))? {
        let page = page?;
        let name = page.file_name().to_string_lossy().into_owned();
        place(&page.path(), &format!("usr/share/man/man1/{name}"))?;
    }
    fs::create_dir_all(tree.join("DEBIAN"))?;
    let control = format!(
        "Package: coface\nVersion: {version}\nArchitecture: {architecture}\nSection: math\nPriority: optional\n\
         Maintainer: the coface authors <authors@coface.invalid>\nDepends: libc6\n\
         Description: exact topology of meshes and cell complexes\n \
         Homology with torsion and generators, surfaces, fundamental groups and covers,\n \
         arrangements and Booleans, persistence, and sets with spline boundaries.\n"
    );
    fs::write(tree.join("DEBIAN/control"), control)?;
    let file = dist.join(format!("coface_{version}_{architecture}.deb"));
    said(Command::new("dpkg-deb").args(["--root-owner-group", "--build"]).arg(&tree).arg(&file))?;
    Ok(Some(file))
}

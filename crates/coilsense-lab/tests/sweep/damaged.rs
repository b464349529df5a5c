//! What is not as it was written: refused in one line, or made anew, and never an answer of its own.
//!
//! Next door: a folder that is whole (`dataset`), the same by the command (`coilsense-cli/tests/sweep.rs`).

use std::collections::BTreeMap;
use std::path::Path;

use coilsense_lab::pareto::{Question, Study};
use coilsense_lab::sweep::{Catalogue, Chunk, Data, Dataset, Plan, PlanParameters};
use sha2::{Digest, Sha256};

use super::dataset::{files, fill, quick};
use super::{QUICK, of};

const MANIFEST: &str = "_manifest.json";

/// The text of a manifest with its digest made anew, as only who means it would.
pub fn sealed_anew(text: &str) -> String {
    let (before, digest) = text.rsplit_once("\"sha256\": \"").unwrap();
    let with = |digest: &str| format!("{before}\"sha256\": \"{digest}\"\n}}\n");
    assert!(digest.len() > 64);
    with(&Sha256::digest(with("")).iter().map(|byte| format!("{byte:02x}")).collect::<String>())
}

/// What is asked of a folder: the front, and how the rows went.
fn asked(folder: &Path) -> Result<String, String> {
    let answer = || {
        let dataset = Dataset::open(folder)?;
        let minimize = ["F_o.rmsd", "spring.mass"].map(str::to_owned);
        let study = Study::of(&dataset, Question::new(dataset.plan(), &minimize, &[], &[])?)?;
        Ok(format!("{study:?} {:?} {:?}", dataset.tally()?, dataset.rows(&[0, 11, 49])?))
    };
    answer().map_err(|error: coilsense_lab::sweep::SweepError| error.to_string())
}

fn put(folder: &Path, name: &str, bytes: &[u8]) {
    std::fs::write(folder.join(name), bytes).unwrap();
}

/// A small sweep, whole: its files, its plan, and what is answered of it.
struct Whole {
    place: tempfile::TempDir,
    plan: Plan,
    files: BTreeMap<String, Vec<u8>>,
    answer: String,
}

impl Whole {
    fn new() -> Self {
        let (place, plan) = (tempfile::tempdir().unwrap(), quick(1));
        fill(place.path(), &plan);
        Self { files: files(place.path()), answer: asked(place.path()).unwrap(), place, plan }
    }

    fn put(&self, name: &str, bytes: &[u8]) {
        put(self.place.path(), name, bytes);
    }

    /// One line of refusal that names the file and, of a chunk, how it is mended.
    fn refusal(&self, name: &str) -> String {
        let line = asked(self.place.path()).unwrap_err();
        assert!(line.contains(name) && !line.contains('\n'), "{line}");
        assert!(
            name == MANIFEST || line.ends_with("; sweep with the same options on the same folder makes it anew"),
            "{line}"
        );
        line
    }

    /// The sweep gone on with makes anew what is told, and leaves the bytes of an unbroken one.
    fn mended(&self, told: &[(u64, &str)]) {
        let dataset = Dataset::create_or_open(self.place.path(), &self.plan).unwrap();
        let damaged = dataset.damaged();
        assert_eq!(damaged.len(), told.len(), "{damaged:?}");
        for ((chunk, why), (expected, words)) in damaged.iter().zip(told) {
            assert!(chunk == expected && why.contains(words) && !why.contains('\n'), "{chunk}: {why}");
        }
        let missing = dataset.missing().unwrap();
        assert!(told.iter().all(|(chunk, _)| missing.contains(chunk)), "{missing:?}");
        drop(dataset);
        fill(self.place.path(), &self.plan);
        assert!(files(self.place.path()) == self.files, "a file differs");
    }
}

/// Numbers that follow from a seed.
fn random(seed: &mut u64) -> usize {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 33) as usize
}

/// Flips a bit at a time, in chunks and now and then in the manifest.
fn flips(count: usize, mut seed: u64) {
    let whole = Whole::new();
    let names: Vec<&String> = whole.files.keys().filter(|name| *name != "_lock").collect();
    let mut refused = 0;
    for turn in 0..count {
        let name = names[random(&mut seed) % names.len()];
        let mut bytes = whole.files[name].clone();
        let bit = random(&mut seed) % (8 * bytes.len());
        bytes[bit / 8] ^= 1 << (bit % 8);
        whole.put(name, &bytes);
        match asked(whole.place.path()) {
            Ok(answer) => assert!(answer == whole.answer && name == MANIFEST, "{name}, bit {bit}"),
            Err(line) => {
                refused += 1;
                assert!(line.contains(name) && !line.contains('\n'), "{name}, bit {bit}: {line}");
            }
        }
        // Rows are made anew in a while; that a chunk is to be, can be seen at once.
        match Dataset::create_or_open(whole.place.path(), &whole.plan) {
            Ok(dataset) if name == MANIFEST => assert_eq!(dataset.damaged(), [], "bit {bit}"),
            Ok(dataset) => assert_eq!(dataset.missing().unwrap().len(), 1, "{name}, bit {bit}"),
            Err(error) => assert!(name == MANIFEST && !error.to_string().contains('\n'), "{name}, bit {bit}: {error}"),
        }
        if turn % 50 == 0 && name != MANIFEST {
            fill(whole.place.path(), &whole.plan);
            assert!(files(whole.place.path()) == whole.files, "{name}, bit {bit}");
        }
        whole.put(name, &whole.files[name]);
    }
    // A space of the manifest may become another.
    assert!(refused > count * 95 / 100, "{refused} of {count}");
}

#[test]
fn a_flipped_bit_is_refused_or_made_anew() {
    flips(600, 1);
}

/// Minutes.
#[test]
#[ignore = "thousands of flips"]
fn five_thousand_flipped_bits_are_refused_or_made_anew() {
    flips(5000, 2);
}

#[test]
fn a_chunk_that_is_cut_off_copied_or_of_another_sweep_is_refused_and_made_anew() {
    let whole = Whole::new();
    let (one, two) = ("chunk-000001.parquet", "chunk-000002.parquet");
    let good = &whole.files[one];
    let other = tempfile::tempdir().unwrap();
    fill(other.path(), &quick(2));
    let of_another = std::fs::read(other.path().join(one)).unwrap();
    let longer = [good.as_slice(), b"PAR1"].concat();
    let cases: [(&[u8], &str); 6] = [
        (&good[..good.len() / 2], "is damaged or cut off"),
        (&[], "is damaged or cut off"),
        (&longer, "is damaged"),
        (&whole.files[two], "holds rows 16 to 23, which are those of another chunk"),
        (&of_another, "is a chunk of another sweep"),
        (b"PAR1PAR1", "is damaged or cut off"),
    ];
    for (bytes, words) in cases {
        whole.put(one, bytes);
        let line = whole.refusal(one);
        assert!(line.contains(words), "{line}");
        whole.mended(&[(1, words)]);
    }
    // Two that changed places, one that is gone, one that is a folder.
    whole.put(one, &whole.files[two]);
    whole.put(two, good);
    std::fs::remove_file(whole.place.path().join("chunk-000000.parquet")).unwrap();
    whole.mended(&[(1, "of another chunk"), (2, "of another chunk")]);
    std::fs::remove_file(whole.place.path().join(one)).unwrap();
    std::fs::create_dir(whole.place.path().join(one)).unwrap();
    assert!(whole.refusal(one).contains("cannot be read"));
    let dataset = Dataset::create_or_open(whole.place.path(), &whole.plan).unwrap();
    assert!(dataset.write(1, good).unwrap_err().to_string().contains("cannot be written"));
}

/// Others' files bear no digest: what is damaged in one is refused, or another number.
#[test]
fn a_catalogue_of_which_a_bit_is_flipped_is_read_or_refused_in_one_line() {
    let place = tempfile::tempdir().unwrap();
    let path = place.path().join("springs.parquet");
    let names = ["a", "b", "a", "c"].map(str::to_owned).to_vec();
    let columns = [
        ("spring.name", Data::Texts(names)),
        ("spring.mass [kg]", Data::Numbers(vec![0.05, 0.06, f64::NAN, 0.08])),
        ("article", Data::Whole(vec![1, 2, 3, 4])),
    ];
    let columns = columns.map(|(title, data)| (title.to_owned(), data)).to_vec();
    let good = Chunk { columns }.to_parquet().unwrap();
    std::fs::write(&path, &good).unwrap();
    assert_eq!(Catalogue::read(&path).unwrap().rows[1], ["b", "0.06", "2"]);
    let mut refused = 0;
    for bit in (0..8 * good.len()).step_by(3) {
        let mut bytes = good.clone();
        bytes[bit / 8] ^= 1 << (bit % 8);
        std::fs::write(&path, &bytes).unwrap();
        if let Err(error) = Catalogue::read(&path) {
            refused += 1;
            let line = error.to_string();
            assert!(line.contains("springs.parquet: ") && !line.contains('\n'), "bit {bit}: {line}");
        }
    }
    assert!(refused > 0);
}

#[test]
fn bytes_that_are_not_a_chunks_own_are_not_written() {
    let whole = Whole::new();
    let dataset = Dataset::create_or_open(whole.place.path(), &whole.plan).unwrap();
    for (bytes, words) in [(&b""[..], "is damaged"), (&whole.files["chunk-000002.parquet"], "of another chunk")] {
        let line = dataset.write(1, bytes).unwrap_err().to_string();
        assert!(line.contains("chunk-000001.parquet") && line.contains(words) && !line.contains('\n'), "{line}");
    }
    drop(dataset);
    assert!(files(whole.place.path()) == whole.files);
}

#[test]
fn a_manifest_that_was_edited_is_refused_by_all() {
    let whole = Whole::new();
    let text = String::from_utf8(whole.files[MANIFEST].clone()).unwrap();
    for (from, to) in [
        ("\"rows\": 50", "\"rows\": 40"),
        ("\"seed\": 1", "\"seed\": 2"),
        ("65 g", "66 g"),
        ("-5..80 g", "-5..81 g"),
        ("\"chunk_rows\": 8", "\"chunk_rows\": 9"),
        ("\"version\": \"", "\"version\": \"9"),
        ("F_o.rmsd", "F_i.rmsd"),
        ("heel strike", "heel  strike"),
    ] {
        assert!(text.contains(from), "{from}");
        whole.put(MANIFEST, text.replacen(from, to, 1).as_bytes());
        assert!(whole.refusal(MANIFEST).contains("has been changed since it was written"), "{from}");
        let line = Dataset::create_or_open(whole.place.path(), &whole.plan).unwrap_err().to_string();
        assert!(line.contains("has been changed since it was written") && !line.contains('\n'), "{from}: {line}");
    }
    // Of another form, and of a plan that this version would not lay out so.
    whole.put(MANIFEST, text.replace("sweep/2", "sweep/1").as_bytes());
    assert!(whole.refusal(MANIFEST).contains("this version reads \"coilsense/sweep/2\""));
    whole.put(MANIFEST, sealed_anew(&text.replacen("\"rows\": 50", "\"rows\": 40", 1)).as_bytes());
    assert!(whole.refusal(MANIFEST).contains("does not understand"));
}

#[test]
fn the_same_spec_by_another_name_or_otherwise_written_down_is_the_same_sweep() {
    let whole = Whole::new();
    let said = |from: &str, to: &str| {
        assert!(QUICK.contains(from), "{from}");
        QUICK.replacen(from, to, 1)
    };
    let plan = |spec: &str| {
        let parameters = of(spec, &["spring.mass=-5..80 g"], &["F_o.rmsd"]);
        let named = PlanParameters { spec_file: "sub/other.toml".to_owned(), ..parameters };
        Plan::new(PlanParameters { rows: Some(50), chunk_rows: Some(8), seed: 1, ..named }).unwrap()
    };
    for same in [
        QUICK.to_owned(),
        format!("# of today\n{QUICK}"),
        said("windings = 12", "windings    =  12.0 # not whole in another"),
        said("damping_ratio = 0", "damping_ratio = 0.0"),
        said("windings = 12\ncoil_radius = \"8 mm\"", "coil_radius = '8 mm'\nwindings = 12"),
    ] {
        let plan = plan(&same);
        assert_eq!(plan.digest(), whole.plan.digest(), "{same}");
        // Made anew under the other name, with reasons that name the first one.
        std::fs::remove_file(whole.place.path().join("chunk-000000.parquet")).unwrap();
        let dataset = Dataset::create_or_open(whole.place.path(), &plan).unwrap();
        for chunk in dataset.missing().unwrap() {
            dataset.write(chunk, &dataset.plan().chunk_bytes(chunk, &|| true).unwrap().unwrap()).unwrap();
        }
        drop(dataset);
        assert!(files(whole.place.path()) == whole.files, "a file differs");
    }
    for other in
        [said("windings = 12", "windings = 13"), said("\"8 mm\"", "\"0.008 m\""), said("heel strike", "heelstrike")]
    {
        let plan = plan(&other);
        assert_ne!(plan.digest(), whole.plan.digest(), "{other}");
        let line = Dataset::create_or_open(whole.place.path(), &plan).unwrap_err().to_string();
        assert!(line.contains("holds another sweep: the spec sub/other.toml says other than spec.toml did"), "{line}");
    }
}

/// A minute, most of which makes the rows. What is printed stands in book/src/decisions/chunks-bear-a-digest.md.
#[test]
#[ignore = "a million rows"]
fn looking_through_a_million_rows_takes_a_small_part_of_finding_their_front() {
    let place = tempfile::tempdir().unwrap();
    let over = ["spring.mass=50..80 g", "spring.stiffness=600..900 N/m", "spring.windings=10..14"];
    let columns = ["stiffness", "mass", "f1", "tau", "stress", "nominal_force", "solid_length", "travel", "index"];
    let plan = Plan::new(PlanParameters { rows: Some(1_000_000), seed: 1, ..of(QUICK, &over, &columns) }).unwrap();
    fill(place.path(), &plan);
    let least = |work: &dyn Fn()| {
        let once = |_| {
            let begun = std::time::Instant::now();
            work();
            begun.elapsed().as_secs_f64()
        };
        (0..3).map(once).fold(f64::INFINITY, f64::min)
    };
    let front = least(&|| {
        let dataset = Dataset::open(place.path()).unwrap();
        let [least, most] =
            [&["stress", "mass"][..], &["f1"]].map(|words| words.iter().map(|w| (*w).to_owned()).collect::<Vec<_>>());
        Study::of(&dataset, Question::new(dataset.plan(), &least, &most, &[]).unwrap()).unwrap();
    });
    let looking = least(&|| drop(Dataset::create_or_open(place.path(), &plan).unwrap()));
    let bytes: usize = files(place.path()).values().map(Vec::len).sum();
    println!("{} MB: the front {front:.2} s, looking through {looking:.2} s", bytes / 1_000_000);
    // One pass over the bytes, beside decoding, comparing and sorting them.
    assert!(looking < 0.5 * front, "{looking} of {front} s");
}

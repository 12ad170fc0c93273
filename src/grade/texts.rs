use std::{env, fs, io, path::Path, path::PathBuf, sync::OnceLock};

macro_rules! texts {
    ($($name:literal)*) => {
        /// Name and text of every sheet that ships: the fitted ones, then those made from a band.
        const TEXTS: &[(&str, &str)] = &[$(($name, include_str!(concat!("../case/library/", $name, ".toml")))),*];
    };
}
texts! {
    "aa5754-o" "aa6016-t4" "aa6016a-surfalex" "aa6022-t4" "aisi304l-bar" "ap04xr" "chalmers-steel" "draw-die-steel"
    "drawing-steel" "if-steel" "osu-steel" "radioss-steel" "stainless-304" "stainless-430" "trip690" "woo-1968"
    "dc01" "dc03" "dc04" "dc05" "dc06" "dx54d" "hc260la" "hc340la" "hc420la" "dp600" "dp800" "1.4016" "1.4301"
    "en-aw-1050" "en-aw-5182" "en-aw-5754" "en-aw-6016" "cu-dhp" "cuzn37"
}

/// File of a sheet, shipped or in the shop's folder.
#[derive(Clone, Copy)]
pub struct SheetText {
    /// Name in a case.
    pub name: &'static str,
    /// Path that messages show.
    pub path: &'static str,
    /// TOML.
    pub text: &'static str,
}

/// Path and text of each of the shop's own sheets, or message and remedy.
type Shop = Result<Vec<(String, String)>, [String; 2]>;

static SHOP: OnceLock<Shop> = OnceLock::new();

/// Takes the shop's own sheets from a folder instead of that of `STAMPFLOW_SHEETS`; before the first look-up.
pub fn use_folder(folder: &Path) -> Result<(), [String; 2]> {
    SHOP.get_or_init(|| shop(folder)).as_ref().map(|_| ()).map_err(Clone::clone)
}

/// Every sheet: those that ship and the shop's own.
pub fn texts() -> Result<impl Iterator<Item = SheetText>, [String; 2]> {
    let read = || env::var_os("STAMPFLOW_SHEETS").map_or(Ok(Vec::new()), |folder| shop(Path::new(&folder)));
    let own = SHOP.get_or_init(read).as_ref().map_err(Clone::clone)?;
    let name = |path: &'static str| Path::new(path).file_stem().and_then(|stem| stem.to_str()).unwrap_or(path);
    let own = own.iter().map(move |(path, text)| SheetText { name: name(path), path, text });
    Ok(TEXTS.iter().map(|&(name, text)| SheetText { name, path: name, text }).chain(own))
}

/// The TOML files of a folder, by name.
pub fn toml_files(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let files = fs::read_dir(folder)?.flatten().map(|file| file.path());
    let mut files: Vec<PathBuf> = files.filter(|path| path.extension().is_some_and(|end| end == "toml")).collect();
    files.sort();
    Ok(files)
}

fn shop(folder: &Path) -> Shop {
    let unreadable = |path: &Path, error: io::Error| {
        let what = format!("the sheets in {} cannot be read: {error}", path.display());
        [what, "give --sheets or STAMPFLOW_SHEETS a folder of sheets, one TOML each".to_owned()]
    };
    let mut texts = Vec::new();
    for path in toml_files(folder).map_err(|error| unreadable(folder, error))? {
        let text = fs::read_to_string(&path).map_err(|error| unreadable(&path, error))?;
        let what = format!("{} has the name of a sheet that ships", path.display());
        let name = path.file_stem().unwrap_or_default();
        if TEXTS.iter().any(|(shipped, _)| *shipped == name) {
            return Err([what, "rename the file: its name is the sheet's".to_owned()]);
        }
        texts.push((path.to_string_lossy().into_owned(), text));
    }
    Ok(texts)
}

//! Simplifies a surface by the interface of C. No crate is needed:
//!
//!     rustc --edition 2021 -L BUILD -l dylib=quadrille c_interface.rs

use std::ffi::{CStr, CString};
use std::marker::PhantomData;
use std::os::raw::{c_char, c_void};

/// The functions of quadrille.h that are used here.
mod c {
    use std::os::raw::{c_char, c_void};

    #[repr(C)]
    pub struct Array {
        pub data: *const c_void,
        pub rows: usize,
        pub columns: usize,
        pub row_stride: isize,
        pub kind: i32,
    }
    pub const FLOAT64: i32 = 0;
    pub const UINT32: i32 = 3;
    pub const INT64: i32 = 6;

    #[repr(C)]
    pub struct Status {
        pub initial_faces: usize,
        pub initial_vertices: usize,
        pub faces: usize,
        pub vertices: usize,
        pub contractions: usize,
        pub next_error: f64,
        pub diagonal: f64,
        pub progress: f64,
        pub stage: i32,
    }
    pub type StatusFunction = extern "C" fn(*mut c_void, *const Status) -> i32;
    pub enum Call {}

    extern "C" {
        pub fn quadrille_call_new() -> *mut Call;
        pub fn quadrille_call_delete(call: *mut Call);
        pub fn quadrille_error(call: *const Call) -> *const c_char;
        pub fn quadrille_set_array(call: *mut Call, name: *const c_char, array: *const Array) -> i32;
        pub fn quadrille_set_double(call: *mut Call, name: *const c_char, value: f64) -> i32;
        pub fn quadrille_set_text(call: *mut Call, name: *const c_char, word: *const c_char) -> i32;
        pub fn quadrille_set_stop(call: *mut Call, function: Option<StatusFunction>, data: *mut c_void);
        pub fn quadrille_simplify(call: *mut Call) -> i32;
        pub fn quadrille_result(call: *mut Call, name: *const c_char, channel: usize, view: *mut Array) -> i32;
        pub fn quadrille_report_text(call: *mut Call) -> *const c_char;
    }
}

/// A number that arrays may have.
trait Number {
    const KIND: i32;
}
impl Number for f64 {
    const KIND: i32 = c::FLOAT64;
}
impl Number for u32 {
    const KIND: i32 = c::UINT32;
}
impl Number for i64 {
    const KIND: i32 = c::INT64;
}

fn text(pointer: *const c_char) -> String {
    unsafe { CStr::from_ptr(pointer) }.to_string_lossy().into_owned()
}

/// A call, which borrows the arrays of its surface.
struct Call<'a> {
    handle: *mut c::Call,
    arrays: PhantomData<&'a ()>,
}

impl<'a> Call<'a> {
    fn new(points: &'a [[f64; 3]], triangles: &'a [[u32; 3]]) -> Result<Self, String> {
        let handle = unsafe { c::quadrille_call_new() };
        if handle.is_null() {
            return Err("out of memory".into());
        }
        let call = Call { handle, arrays: PhantomData };
        call.set_rows("points", points)?;
        call.set_rows("triangles", triangles)?;
        Ok(call)
    }

    fn check(&self, code: i32) -> Result<(), String> {
        match code {
            0 => Ok(()),
            _ => Err(text(unsafe { c::quadrille_error(self.handle) })),
        }
    }

    fn set_rows<T: Number>(&self, name: &str, rows: &'a [[T; 3]]) -> Result<(), String> {
        let name = CString::new(name).unwrap();
        let data = rows.as_ptr() as *const c_void;
        let array = c::Array { data, rows: rows.len(), columns: 3, row_stride: 0, kind: T::KIND };
        self.check(unsafe { c::quadrille_set_array(self.handle, name.as_ptr(), &array) })
    }

    fn set(&self, name: &str, value: f64) -> Result<(), String> {
        let name = CString::new(name).unwrap();
        self.check(unsafe { c::quadrille_set_double(self.handle, name.as_ptr(), value) })
    }

    fn set_word(&self, name: &str, word: &str) -> Result<(), String> {
        let (name, word) = (CString::new(name).unwrap(), CString::new(word).unwrap());
        self.check(unsafe { c::quadrille_set_text(self.handle, name.as_ptr(), word.as_ptr()) })
    }

    /// The run ends once `stop` returns true. It has to live until the call has run.
    fn set_stop<F: FnMut(&c::Status) -> bool>(&self, stop: &'a mut F) {
        extern "C" fn ask<F: FnMut(&c::Status) -> bool>(data: *mut c_void, status: *const c::Status) -> i32 {
            let stop = unsafe { &mut *(data as *mut F) };
            i32::from(stop(unsafe { &*status }))
        }
        unsafe { c::quadrille_set_stop(self.handle, Some(ask::<F>), stop as *mut F as *mut c_void) };
    }

    fn run(&mut self) -> Result<String, String> {
        self.check(unsafe { c::quadrille_simplify(self.handle) })?;
        Ok(text(unsafe { c::quadrille_report_text(self.handle) }))
    }

    /// An array of the result, which is valid until the next run.
    fn result<T: Number>(&self, name: &str) -> Result<&[T], String> {
        let name = CString::new(name).unwrap();
        let mut view = c::Array { data: std::ptr::null(), rows: 0, columns: 0, row_stride: 0, kind: 0 };
        self.check(unsafe { c::quadrille_result(self.handle, name.as_ptr(), 0, &mut view) })?;
        if view.rows == 0 {
            return Ok(&[]);
        }
        if view.kind != T::KIND {
            return Err("the array has another type".into());
        }
        Ok(unsafe { std::slice::from_raw_parts(view.data as *const T, view.rows * view.columns) })
    }
}

impl Drop for Call<'_> {
    fn drop(&mut self) {
        unsafe { c::quadrille_call_delete(self.handle) };
    }
}

/// A bent sheet of n × n points.
fn sheet(n: u32) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let mut points = Vec::new();
    let mut triangles = Vec::new();
    for i in 0..n * n {
        let (x, y) = (f64::from(i % n) / f64::from(n - 1), f64::from(i / n) / f64::from(n - 1));
        points.push([x, y, 0.1 * (6.0 * x).sin() * (6.0 * y).cos()]);
        if i % n > 0 && i >= n {
            triangles.push([i - n - 1, i - n, i]);
            triangles.push([i - n - 1, i, i - 1]);
        }
    }
    (points, triangles)
}

fn main() -> Result<(), String> {
    let (points, triangles) = sheet(100);
    let mut questions = 0;
    let mut stop = |status: &c::Status| {
        questions += 1;
        status.faces <= 1000
    };
    let mut call = Call::new(&points, &triangles)?;
    call.set_word("cost", "memoryless_quadric")?;
    call.set("relative_error", 0.01)?;
    call.set("maps", 1.0)?;
    call.set_stop(&mut stop);
    println!("{}", call.run()?);

    // The place of each point of the input on the result, by the weights of up to three points.
    let places: &[f64] = call.result("points")?;
    let (begins, indices, weights) = (
        call.result::<i64>("old_to_new_begins")?,
        call.result::<i64>("old_to_new_indices")?,
        call.result::<f64>("old_to_new_weights")?,
    );
    let mut farthest = 0.0_f64;
    for (row, point) in points.iter().enumerate() {
        let mut place = [0.0; 3];
        for entry in begins[row] as usize..begins[row + 1] as usize {
            for k in 0..3 {
                place[k] += weights[entry] * places[3 * indices[entry] as usize + k];
            }
        }
        let squares = (0..3).map(|k| (place[k] - point[k]).powi(2));
        farthest = farthest.max(squares.sum::<f64>().sqrt());
    }
    println!("a point is at most {farthest:.4} from its place");

    let error = call.set("ratio", 2.0).unwrap_err(); // errors are texts
    assert_eq!(error, "ratio is 2, not in [0, 1]");
    drop(call);
    println!("{questions} questions");
    if questions == 0 || farthest > 0.02 {
        return Err("that cannot be".into());
    }
    Ok(())
}

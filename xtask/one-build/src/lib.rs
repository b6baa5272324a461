//! Features that one program of the workspace turns on in what all of them build with: see the manifest.

//! Pieces of contours and ways as tests/oracles/lathe.py reads them.

use serde_json::{Value, json};
use technolog::turning::contour::{Curve, Piece, Turn};

/// Its ends as radius and Z, mm; of an arc its radius, its turn and its centre too.
pub fn told_piece(piece: Piece) -> Value {
    let mut object = json!({
        "from": [piece.from.radius.to_mm(), piece.from.z.to_mm()],
        "to": [piece.to.radius.to_mm(), piece.to.z.to_mm()],
    });
    if let (Curve::Arc { radius, turn }, Some(centre)) = (piece.curve, piece.centre()) {
        object["radius"] = json!(radius.to_mm());
        object["left"] = json!(turn == Turn::Left);
        object["centre"] = json!([centre.radius, centre.z]);
    }
    object
}

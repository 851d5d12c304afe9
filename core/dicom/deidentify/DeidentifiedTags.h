// SPDX-License-Identifier: Apache-2.0
#pragma once

class DcmTagKey;

namespace core {

/// What becomes of an attribute when the patient is taken out of an object.
enum class TagFate {
    Remove, ///< whatever is not named below
    Keep, ///< tells of pixels, places, acquisition and codes
    Empty, ///< must be there (type 2)
    Enter, ///< a sequence: its items are treated likewise
    Date,
    Time,
    NeededDate, ///< must have a value (type 1)
    NeededTime,
    Device,
    Description,
};

/// Of an attribute of an even group outside curves and overlays that is no UID; those are mapped.
/// Follows PS3.15 table E.1-1 (X, Z, D, K, C), and removes what that does not name either.
/// Only for sources of core/dicom.
[[nodiscard]] TagFate fateOf(const DcmTagKey& tag);

} // namespace core

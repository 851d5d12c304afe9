// SPDX-License-Identifier: Apache-2.0
#pragma once

class DcmTagKey;

namespace core {

/// How an attribute is treated when an object is de-identified.
enum class TagFate {
    Remove, ///< everything that is not listed below
    Keep, ///< describes pixels, positions, acquisition or codes only
    Empty, ///< must be present (type 2), so it stays without a value
    Enter, ///< a sequence whose items are treated in the same way
    /// kept in objects that Burin makes, where the text is neutral; removed from all others
    OwnText,
    OwnItems, ///< as Enter in objects that Burin makes; removed from all others
    Date,
    Time,
    NeededDate, ///< must have a value (type 1)
    NeededTime,
    Device,
    Description,
};

/// The treatment of an attribute of an even group, outside curves and overlays, that is not a UID
/// (UIDs are mapped). It follows PS3.15 table E.1-1 (X, Z, D, K, C) and removes what that table
/// does not list. Only for sources of core/dicom.
[[nodiscard]] TagFate fateOf(const DcmTagKey& tag);

} // namespace core

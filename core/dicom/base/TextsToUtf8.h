// SPDX-License-Identifier: Apache-2.0
#pragma once

class DcmItem;

namespace core {

/// Converts every text of a data set or item to UTF-8 and declares that, also in sequences, whose
/// items may declare other character sets than the data set. What cannot be converted as it is
/// declared is read as dicomText() reads it, so that no text is left as it was. (DCMTK's own
/// conversion ends at the first such text, and leaves it and all others behind it.) Only for
/// sources of core/dicom.
void textsToUtf8(DcmItem& set);

} // namespace core

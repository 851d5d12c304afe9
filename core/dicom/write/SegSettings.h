// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"

#include <QString>

#include <map>

namespace core {

/// How segments were made, in the terms of DICOM SEG.
enum class SegAlgorithm { Manual, Semiautomatic, Automatic };

/// The codes of a segment besides its type; those that are not set are not written.
struct SegCodes {
    CodedConcept category; ///< not set: the one for all segments
    CodedConcept modifier; ///< of the type: "Left"
    CodedConcept region; ///< where it is, for structures that occur in several places: "Liver"
    CodedConcept regionModifier;
};

/// How a DICOM SEG is written.
struct SegSettings {
    bool deflated = false; ///< the whole data set is compressed (deflated transfer syntax)
    SegAlgorithm algorithm = SegAlgorithm::Semiautomatic;
    QString algorithmName = QStringLiteral("Burin"); ///< for all but manual segments
    std::map<int, SegCodes> codes{}; ///< by label
};

/// The codes of a segment, with the category for all segments where it has none of its own.
[[nodiscard]] SegCodes codesIn(
    const SegSettings& settings, int label, const CodedConcept& category);

} // namespace core

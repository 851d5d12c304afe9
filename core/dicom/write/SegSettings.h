// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"

#include <QString>

#include <map>

namespace core {

/// How segments came about, as a DICOM SEG says it.
enum class SegAlgorithm { Manual, Semiautomatic, Automatic };

/// What a DICOM SEG says of a segment beside its type; not set: nothing.
struct SegCodes {
    CodedConcept category; ///< not set: that of all
    CodedConcept modifier; ///< of the type: "Left"
    CodedConcept region; ///< where it lies, for what can lie in several places: "Liver"
    CodedConcept regionModifier;
};

struct SegSettings {
    bool deflated = false; ///< compressed whole, in the deflated transfer syntax
    SegAlgorithm algorithm = SegAlgorithm::Semiautomatic;
    QString algorithmName = QStringLiteral("Burin"); ///< of all but manual ones
    std::map<int, SegCodes> codes{}; ///< by label
};

} // namespace core

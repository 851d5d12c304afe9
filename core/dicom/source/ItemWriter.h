// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/items/ConditionChain.h"
#include "core/dicom/source/SegSource.h"
#include "core/document/Document.h"

#include <QString>

#include <glm/glm.hpp>

#include <string>
#include <vector>

class DcmItem;
class DcmTagKey;

namespace core {

/// Writes attributes of DICOM items; failures are recorded in the chain. An item that could not be
/// created is null, and writing to it does nothing. Only for sources of core/dicom.
class ItemWriter {
public:
    explicit ItemWriter(ConditionChain& chain)
        : m_chain(chain)
    {
    }

    /// Appends a new item to a sequence, which is created if it is missing.
    DcmItem* append(DcmItem* parent, const DcmTagKey& sequence) const;
    void put(DcmItem* item, const DcmTagKey& tag, const std::string& value) const;
    void put(DcmItem* item, const DcmTagKey& tag, const QString& value) const;
    void put(DcmItem* item, const DcmTagKey& tag, const char* value) const;
    /// US
    void putWord(DcmItem* item, const DcmTagKey& tag, int value) const;
    /// FL: x, y and z of each place
    void putFloats(
        DcmItem* item, const DcmTagKey& tag, const std::vector<glm::dvec3>& places) const;
    /// A sequence of one item that holds a code.
    void putCode(DcmItem* item, const DcmTagKey& sequence, const CodedConcept& code) const;
    /// A reference: SOP class, instance and, for a multi-frame file, the frame.
    void refer(DcmItem* item, const SegSlice& slice) const;
    /// References to all images of the slices, each once: an item of @p seriesSequence for each
    /// series, containing one of @p imageSequence for each image.
    void referAll(DcmItem* parent, const DcmTagKey& seriesSequence, const DcmTagKey& imageSequence,
        const std::vector<SegSlice>& slices) const;

private:
    ConditionChain& m_chain;
};

/// Whether DICOM can hold a code: scheme and value of 1 to 16 characters, ASCII, meaning 1 to 64.
[[nodiscard]] bool fitsCodeSequence(const CodedConcept& code);

} // namespace core

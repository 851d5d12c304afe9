// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/document/Document.h"

#include <QString>

#include <cstdint>

namespace core {

struct AddSegment {
    QString name{};
    std::uint32_t rgb = 0;
    CodedConcept code{};
};

} // namespace core

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/open/OpenStroke.h"

namespace core {

/// A preview of an edit that is complete when it begins; it stands open until the user decides.
class OpenPreview final : public OpenStroke {
public:
    [[nodiscard]] OpenManner manner() const override
    {
        return {.withoutPen = true, .endsIfRefused = true};
    }
};

} // namespace core

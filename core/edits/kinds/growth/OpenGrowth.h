// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/open/OpenStroke.h"

#include <optional>

namespace core {

/// A running growth. It takes requests for further steps (GrowAdvance) and to stop where it is
/// (PauseGrowth). Once the user has watched it, or its guard has stopped it, its edit says how far
/// it came.
class OpenGrowth : public OpenStroke {
public:
    /// @param steps of the edit; none: to closure
    explicit OpenGrowth(std::optional<int>& steps);

    [[nodiscard]] OpenManner manner() const override;
    [[nodiscard]] Told begin(
        const EngineEdit& command, const Document& document, bool isWhole) override;
    [[nodiscard]] Result<Told> extend(
        const StrokeExtension& extension, const Document& document) override;
    void carriedOut(const EngineResult& result, bool isWhole) override;

private:
    std::optional<int>& m_steps;
};

} // namespace core

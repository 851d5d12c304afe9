// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/parts/PenSample.h"
#include "core/edits/kinds/sculpt/DrillPathSampler.h"
#include "core/edits/open/OpenStroke.h"

#include <functional>
#include <optional>
#include <vector>

namespace core {

/// The open stroke of a tool that a pen presses into the volume: drill and laser. It takes further
/// samples of the pen (PenSamples).
class OpenPen final : public OpenStroke {
public:
    using MakeSampler = std::function<DrillPathSampler(const EngineEdit& command)>;

    /// @param samples of the edit
    OpenPen(std::vector<PenSample>& samples, MakeSampler makeSampler);

    [[nodiscard]] Told begin(
        const EngineEdit& command, const Document& document, bool isWhole) override;
    [[nodiscard]] Result<Told> extend(
        const StrokeExtension& extension, const Document& document) override;
    [[nodiscard]] Told lift() override;

private:
    std::vector<PenSample>& m_samples;
    MakeSampler m_makeSampler;
    std::optional<DrillPathSampler> m_path; ///< once it has begun
};

} // namespace core

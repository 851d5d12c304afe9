// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EditEngine.h"
#include "tests/reference/fields/DenseFields.h"

#include <memory>

namespace reference {

class Oracle;

/// The oracle: the seam's second implementation, dense, sequential and slow, written from the rules
/// in core/engine and core/sculpt alone. It carries a command out inside submit(), so a paced
/// growth runs at once and a pause never finds steps to forget. It wakes on the caller's thread,
/// inside submit(). Its results take no time: `milliseconds` is 0.
class ReferenceEngine final : public core::EditEngine {
public:
    ReferenceEngine();
    ~ReferenceEngine() override;
    ReferenceEngine(const ReferenceEngine&) = delete;
    ReferenceEngine& operator=(const ReferenceEngine&) = delete;

    core::Result<void> openVolume(
        const glm::ivec3& size, std::span<const std::uint16_t> codes) override;
    core::Ticket submit(core::EngineCommand command) override;
    [[nodiscard]] std::vector<core::EngineResult> collect() override;
    void finish() override { }
    void setWakeUp(std::function<void()> wakeUp) override;
    [[nodiscard]] core::GrowthProgress growthProgress() const override;
    void expectEditableRanges() override { ++rangesExpected; }
    int rangesExpected = 0; ///< how often it was told of them

    [[nodiscard]] const DenseFields& fields() const;
    /// Radiation of the layers that are not muted, as it is now.
    [[nodiscard]] DenseArray<std::uint8_t> carved() const;

private:
    std::unique_ptr<Oracle> m_oracle;
};

} // namespace reference

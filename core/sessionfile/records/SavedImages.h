// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

namespace core {

class StagedFile;

/// Of "Save session as …": whether the study's images are in the new file.
struct SavedImages {
    /// Those that the session's file holds go along.
    bool kept = true;
    /// Made by stageImages() for the same target, which then takes the session in; null: no others.
    std::shared_ptr<StagedFile> staged{};
};

} // namespace core

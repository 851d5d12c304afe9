// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

namespace core {

class StagedFile;

/// Whether "Save session as …" puts the study's images into the new file.
struct SavedImages {
    /// Keep the images that the session's file already holds.
    bool kept = true;
    /// A file that stageImages() made for the same target and that then receives the session; null:
    /// none.
    std::shared_ptr<StagedFile> staged{};
};

} // namespace core

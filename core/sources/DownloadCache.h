// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/files/FolderCache.h"
#include "core/pacs/retrieve/PacsRetrieve.h"

namespace core {

/// The cache of downloaded studies.
class DownloadCache : public FolderCache {
public:
    using FolderCache::FolderCache;

    /// The path for a requested study of a source, whether or not it exists.
    [[nodiscard]] QString pathOf(const QString& address, const RetrieveWish& wish) const;
};

} // namespace core

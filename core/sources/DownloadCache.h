// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/files/FolderCache.h"
#include "core/pacs/retrieve/PacsRetrieve.h"

namespace core {

/// What was downloaded.
class DownloadCache : public FolderCache {
public:
    using FolderCache::FolderCache;

    /// Where a wish at a source has its place, whether it is there or not.
    [[nodiscard]] QString pathOf(const QString& address, const RetrieveWish& wish) const;
};

} // namespace core

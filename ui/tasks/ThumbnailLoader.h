// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/TaskThread.h"
#include "core/volume/Volume.h"

#include <QImage>
#include <QObject>
#include <QStringList>

#include <atomic>

namespace ui {

/// The middle slice of a volume in its own grey mapping, in true proportions, on black.
[[nodiscard]] QImage thumbnail(const core::LoadedVolume& volume, int size);

/// Makes small pictures of image files, one after the other, beside the GUI thread. What cannot be
/// read has no picture.
class ThumbnailLoader : public QObject {
    Q_OBJECT

public:
    ThumbnailLoader(const QStringList& files, int size);
    ~ThumbnailLoader() override; ///< stops after the file at hand

Q_SIGNALS:
    void ready(int index, const QImage& picture);

private:
    std::atomic<bool> m_stop = false;
    core::TaskThread m_worker; ///< last: it uses all of the above
};

} // namespace ui

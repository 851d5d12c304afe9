// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QImage>
#include <QSize>

#include <vector>

class QWidget;

namespace test {

/// The middle of what a view or panel shows, as it is on the screen.
/// @param size of what is cut out; as much of it as there is
[[nodiscard]] QImage middleOf(QWidget& shown, const QSize& size);

/// Saves pictures in rows, from the left and each row in its middle, on the window's colour, in the
/// folder that BURIN_SCREENSHOTS names. The file has 256 colours at most, which makes it about a
/// third as large.
/// @return whether it was saved
[[nodiscard]] bool keepCollage(const std::vector<std::vector<QImage>>& rows, const char* name);

} // namespace test

// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ui {

class MainWindow;

/// "From PACS …" and "Send to PACS …" of the File menu; keeps the copy that the open study is.
void addPacsActions(MainWindow& window);

} // namespace ui

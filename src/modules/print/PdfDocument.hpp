#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace naocal {

/// An axis-parallel rectangle on a page; y points down [mm].
struct PageBox {
  double x = 0, y = 0, width = 0, height = 0;

  double right() const { return x + width; }
  double bottom() const { return y + height; }
};

/// Red, green and blue, each 0 to 1.
struct PageColour {
  double red = 0, green = 0, blue = 0;
};

enum class TextAlign { left, centre, right };

struct TextStyle {
  double size = 3; // height of the font; capitals have 0.72 of it [mm]
  TextAlign align = TextAlign::left;
  double turn = 0; // counter-clockwise, as read [rad]
  bool bold = false;
  PageColour colour = {};
};

/// A PDF of vector graphics. All lengths are millimetres from the origin, at first the top left corner of the page, y
/// down. Text is Helvetica, one of the fonts that every PDF reader has; characters outside Windows-1252 become "?".
/// Equal calls give equal bytes: the file holds no date.
class PdfDocument {
public:
  /// `creator` is stored in the file, so that a command recognises the PDFs that it may replace.
  PdfDocument(std::string_view creator, std::string_view title);
  ~PdfDocument();
  PdfDocument(const PdfDocument&) = delete;
  PdfDocument& operator=(const PdfDocument&) = delete;

  /// Starts a page; what follows is drawn on it, with the origin in its top left corner.
  void addPage(double width, double height);

  /// Moves the origin: coordinates count from this point of the page.
  void setOrigin(const Eigen::Vector2d& onPage);

  /// Fills rectangles as one area, without seams between those that touch.
  void fill(const std::vector<PageBox>& boxes, const PageColour& colour = {});
  void fillPolygon(const std::vector<Eigen::Vector2d>& corners, const PageColour& colour);
  void drawPolygon(const std::vector<Eigen::Vector2d>& corners, double width, const PageColour& colour = {});
  /// `dash`: length of dashes and gaps; 0: solid.
  void drawLine(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width, const PageColour& colour = {},
                double dash = 0);
  void drawCircle(const Eigen::Vector2d& centre, double radius, double width, const PageColour& colour = {});

  /// Writes a line of text; `at`: the point of its base line at which it is aligned.
  void write(const Eigen::Vector2d& at, std::string_view text, const TextStyle& style = {});
  /// Width of a line of text [mm].
  double textWidth(std::string_view text, double size, bool bold = false);

  /// Restricts drawing to a rectangle until `endClip`.
  void beginClip(const PageBox& box);
  void endClip();

  /// The bytes of the PDF. Throws std::runtime_error if the PDF library reports an error.
  std::string finish();

private:
  struct Library;
  std::unique_ptr<Library> library_;
};

/// Whether bytes are a PDF with this creator.
bool isPdfOf(std::string_view bytes, std::string_view creator);

} // namespace naocal

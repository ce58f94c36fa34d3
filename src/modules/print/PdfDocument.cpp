#include "print/PdfDocument.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <hpdf.h>
#include <numbers>
#include <stdexcept>

namespace naocal {

namespace {

constexpr double pointsPerMillimetre = 72 / 25.4; // of PDF: ISO 32000-1, 8.3.2.3

HPDF_REAL points(double millimetres) {
  return static_cast<HPDF_REAL>(pointsPerMillimetre * millimetres);
}

/// Characters of Windows-1252 outside Latin-1 that our texts use.
char dashOrQuestion(std::uint32_t character) {
  switch (character) {
  case 0x2013: // en dash
    return '\x96';
  case 0x2014: // em dash
    return '\x97';
  case 0x2026: // ellipsis
    return '\x85';
  case 0x2022: // bullet
    return '\x95';
  default:
    return '?';
  }
}

/// Converts UTF-8 to Windows-1252.
std::string toWindows1252(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const auto first = static_cast<unsigned char>(text[i]);
    const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    std::uint32_t character = length == 1 ? first : first & (0xFFU >> (length + 1));
    for (std::size_t k = 1; k < length && i + k < text.size(); ++k) {
      character = (character << 6) | (static_cast<unsigned char>(text[i + k]) & 0x3FU);
    }
    const bool isLatin1 = (character >= 0x20 && character < 0x7F) || (character >= 0xA0 && character < 0x100);
    result += isLatin1 ? static_cast<char>(character) : dashOrQuestion(character);
    i += length;
  }
  return result;
}

} // namespace

struct PdfDocument::Library {
  HPDF_Doc document = HPDF_New(nullptr, nullptr);
  HPDF_Page page = nullptr;
  double height = 0;                                // of the page [mm]
  Eigen::Vector2d origin = Eigen::Vector2d::Zero(); // on the page [mm]

  HPDF_REAL x(double millimetres) const { return points(origin.x() + millimetres); }
  HPDF_REAL y(double millimetres) const { return points(height - origin.y() - millimetres); }
  HPDF_Font font(bool bold) const {
    return HPDF_GetFont(document, bold ? "Helvetica-Bold" : "Helvetica", "WinAnsiEncoding");
  }
  void setFill(const PageColour& colour) const {
    HPDF_Page_SetRGBFill(page, HPDF_REAL(colour.red), HPDF_REAL(colour.green), HPDF_REAL(colour.blue));
  }
  void setPen(double width, const PageColour& colour, double dash = 0) const {
    HPDF_Page_SetRGBStroke(page, HPDF_REAL(colour.red), HPDF_REAL(colour.green), HPDF_REAL(colour.blue));
    HPDF_Page_SetLineWidth(page, points(width));
    const auto length = static_cast<HPDF_UINT16>(std::lround(points(dash)));
    const std::array<HPDF_UINT16, 1> pattern{length};
    HPDF_Page_SetDash(page, length > 0 ? pattern.data() : nullptr, length > 0 ? 1 : 0, 0);
  }
  void trace(const std::vector<Eigen::Vector2d>& corners) const {
    HPDF_Page_MoveTo(page, x(corners.front().x()), y(corners.front().y()));
    for (std::size_t i = 1; i < corners.size(); ++i) {
      HPDF_Page_LineTo(page, x(corners[i].x()), y(corners[i].y()));
    }
  }
  void addBox(const PageBox& box) const {
    HPDF_Page_Rectangle(page, x(box.x), y(box.bottom()), points(box.width), points(box.height));
  }
};

PdfDocument::PdfDocument(std::string_view creator, std::string_view title) : library_{std::make_unique<Library>()} {
  if (library_->document == nullptr) {
    throw std::runtime_error{"libharu cannot begin a PDF"};
  }
  HPDF_SetCompressionMode(library_->document, HPDF_COMP_ALL);
  HPDF_SetInfoAttr(library_->document, HPDF_INFO_CREATOR, std::string{creator}.c_str());
  HPDF_SetInfoAttr(library_->document, HPDF_INFO_TITLE, toWindows1252(title).c_str());
}

PdfDocument::~PdfDocument() {
  HPDF_Free(library_->document);
}

void PdfDocument::addPage(double width, double height) {
  library_->page = HPDF_AddPage(library_->document);
  library_->height = height;
  library_->origin.setZero();
  HPDF_Page_SetWidth(library_->page, points(width));
  HPDF_Page_SetHeight(library_->page, points(height));
}

void PdfDocument::setOrigin(const Eigen::Vector2d& onPage) {
  library_->origin = onPage;
}

void PdfDocument::fill(const std::vector<PageBox>& boxes, const PageColour& colour) {
  if (boxes.empty()) {
    return;
  }
  library_->setFill(colour);
  for (const PageBox& box : boxes) {
    library_->addBox(box);
  }
  HPDF_Page_Fill(library_->page);
}

void PdfDocument::fillPolygon(const std::vector<Eigen::Vector2d>& corners, const PageColour& colour) {
  library_->setFill(colour);
  library_->trace(corners);
  HPDF_Page_ClosePath(library_->page);
  HPDF_Page_Fill(library_->page);
}

void PdfDocument::drawPolygon(const std::vector<Eigen::Vector2d>& corners, double width, const PageColour& colour) {
  library_->setPen(width, colour);
  library_->trace(corners);
  HPDF_Page_ClosePathStroke(library_->page);
}

void PdfDocument::drawLine(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width,
                           const PageColour& colour, double dash) {
  library_->setPen(width, colour, dash);
  library_->trace({from, to});
  HPDF_Page_Stroke(library_->page);
}

void PdfDocument::drawCircle(const Eigen::Vector2d& centre, double radius, double width, const PageColour& colour) {
  library_->setPen(width, colour);
  HPDF_Page_Circle(library_->page, library_->x(centre.x()), library_->y(centre.y()), points(radius));
  HPDF_Page_Stroke(library_->page);
}

void PdfDocument::write(const Eigen::Vector2d& at, std::string_view text, const TextStyle& style) {
  const double share = style.align == TextAlign::left ? 0 : style.align == TextAlign::centre ? 0.5 : 1;
  const double back = share * textWidth(text, style.size, style.bold);
  const double cosine = std::cos(style.turn), sine = std::sin(style.turn);
  library_->setFill(style.colour);
  HPDF_Page_SetFontAndSize(library_->page, library_->font(style.bold), points(style.size));
  HPDF_Page_BeginText(library_->page);
  HPDF_Page_SetTextMatrix(library_->page, HPDF_REAL(cosine), HPDF_REAL(sine), HPDF_REAL(-sine), HPDF_REAL(cosine),
                          library_->x(at.x() - back * cosine), library_->y(at.y() + back * sine));
  HPDF_Page_ShowText(library_->page, toWindows1252(text).c_str());
  HPDF_Page_EndText(library_->page);
}

double PdfDocument::textWidth(std::string_view text, double size, bool bold) {
  const std::string encoded = toWindows1252(text);
  const auto* const bytes = reinterpret_cast<const HPDF_BYTE*>(encoded.data()); // libharu's type for text
  const HPDF_TextWidth width = HPDF_Font_TextWidth(library_->font(bold), bytes, static_cast<HPDF_UINT>(encoded.size()));
  return size * static_cast<double>(width.width) / 1000;
}

void PdfDocument::beginClip(const PageBox& box) {
  HPDF_Page_GSave(library_->page);
  library_->addBox(box);
  HPDF_Page_Clip(library_->page);
  HPDF_Page_EndPath(library_->page);
}

void PdfDocument::endClip() {
  HPDF_Page_GRestore(library_->page);
}

std::string PdfDocument::finish() {
  HPDF_SaveToStream(library_->document);
  HPDF_ResetStream(library_->document);
  std::string bytes(HPDF_GetStreamSize(library_->document), '\0');
  auto size = static_cast<HPDF_UINT32>(bytes.size());
  HPDF_ReadFromStream(library_->document, reinterpret_cast<HPDF_BYTE*>(bytes.data()), &size);
  const HPDF_STATUS error = HPDF_GetError(library_->document);
  if (size != bytes.size() || (error != HPDF_OK && error != HPDF_STREAM_EOF)) {
    throw std::runtime_error{fmt::format("libharu reports error 0x{:04X} while it writes a PDF", error)};
  }
  return bytes;
}

bool isPdfOf(std::string_view bytes, std::string_view creator) {
  return bytes.starts_with("%PDF-") && bytes.find(fmt::format("/Creator ({})", creator)) != std::string_view::npos;
}

} // namespace naocal

// Calibrates a capture set, asks what the model lacks, and writes what was found.
#include <naocal/io/InputError.hpp>
#include <naocal/naocal.hpp>

#include <exception>
#include <iostream>

int main(int count, char** arguments) {
  if (count != 3) {
    std::cerr << "usage: calibrate CAPTURES RESULT.json\n";
    return 2;
  }
  try {
    const naocal::Captures captures = naocal::readCaptures({arguments[1]});
    const naocal::Calibrated calibrated = naocal::calibrate(captures);
    std::cout << naocal::printableText(calibrated.result.sentence)
              << '\n'; // names in files reach no terminal as commands
    for (const naocal::Term& term : calibrated.model.terms()) {
      const naocal::Estimate& estimate = calibrated.result.estimates[term.first];
      std::cout << naocal::printableText(term.label()) << ": " << estimate.best() << " +- " << estimate.bestSigma()
                << ' ' << term.effect.unknowns.front().unit << '\n';
    }
    std::cout << naocal::printableText(naocal::diagnose(captures).sentence) << '\n';
    naocal::writeResult(captures, calibrated, arguments[2]);
    return calibrated.result.usable ? 0 : 3;
  } catch (const std::exception& error) {
    std::cerr << naocal::printableText(error.what()) << '\n';
    return 2;
  }
}

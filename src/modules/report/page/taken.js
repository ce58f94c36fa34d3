// Poses and captures by name.

const {poseName, poseTip, captureName} = takenNames(data);

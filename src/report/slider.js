document.querySelectorAll('.motion').forEach(motion => {
  const frames = motion.querySelectorAll('.frame'), slider = motion.querySelector('input');
  slider.addEventListener('input', () => frames.forEach((frame, i) => frame.hidden = i != slider.value));
});

//! A list that is usually short and then needs no heap. A plan queries decision tables thousands of times, and each
//! answer has a few inputs and one row.

/// Values in order, the first `N` of them inline.
#[derive(Debug, Clone)]
pub struct Few<T, const N: usize> {
    first: [T; N],
    /// How many of the first there are.
    count: usize,
    others: Vec<T>,
}

impl<T: Copy + Default, const N: usize> Default for Few<T, N> {
    fn default() -> Self {
        Self { first: [T::default(); N], count: 0, others: Vec::new() }
    }
}

impl<T: Copy, const N: usize> Few<T, N> {
    /// Appends a value.
    pub fn push(&mut self, value: T) {
        match self.first.get_mut(self.count) {
            Some(free) => {
                *free = value;
                self.count += 1;
            }
            None => self.others.push(value),
        }
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.count + self.others.len()
    }

    /// All of them.
    pub fn iter(&self) -> impl Iterator<Item = T> + '_ {
        self.first[..self.count].iter().chain(&self.others).copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_a_list_however_many_there_are() {
        let mut few = Few::<u32, 2>::default();
        for number in 0..5 {
            assert_eq!(few.len(), number as usize);
            assert_eq!(few.iter().collect::<Vec<_>>(), (0..number).collect::<Vec<_>>());
            few.push(number);
        }
    }
}
